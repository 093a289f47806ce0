// Given rays and spheres against tests/reference/oracle.py, which knows only Python's integers.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "reference/exact_ray.h"
#include "scene/number.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Ray;
using scene::Root;
using scene::Sphere;

struct Case {
  Ray ray;
  Sphere sphere;
};

/// A file of this process that removes itself.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("raycheck_" + std::to_string(getpid()) + "_" + name)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// The oracle's answers, a line a case; fails when it cannot be asked.
std::vector<std::string> ask_oracle(const std::vector<Case>& cases) {
  const TemporaryFile questions("questions.txt");
  const TemporaryFile answers("answers.txt");
  {
    std::ofstream out(questions.path());
    for (const auto& [ray, sphere] : cases) {
      const auto& [o, d] = ray;
      const scene::Point3& c = sphere.centre;
      for (const double x : {o.x, o.y, o.z, d.x, d.y, d.z, c.x, c.y, c.z, sphere.radius}) {
        out << scene::hexfloat(x) << ' ';
      }
      out << '\n';
    }
  }
  const std::string command = "python3 '" RAYCHECK_SOURCE_DIR "/tests/reference/oracle.py' < '" +
                              questions.path() + "' > '" + answers.path() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << "python3 is needed: " << command;
  std::vector<std::string> lines;
  std::ifstream in(answers.path());
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// One line of the oracle.
struct Answer {
  std::string line_class;
  int smaller_sign = 0;
  int larger_sign = 0;
  double smaller = 0;
  double larger = 0;

  explicit Answer(const std::string& line) {
    std::istringstream in(line);
    std::string smaller_text;
    std::string larger_text;
    in >> line_class;
    if (line_class == "miss") return;
    in >> smaller_sign >> larger_sign >> smaller_text >> larger_text;
    smaller = std::strtod(smaller_text.c_str(), nullptr);
    larger = std::strtod(larger_text.c_str(), nullptr);
  }
  Intersection intersection(Root convention) const {
    if (line_class == "miss") return {};
    const HitClass hit = line_class == "tangent" ? HitClass::kTangent : HitClass::kHit;
    if (smaller_sign >= 0) return {hit, WhichRoot::kSmaller};
    if (convention == Root::kSmaller || larger_sign < 0) return {};
    return {hit, WhichRoot::kLarger};
  }
};

struct Counts {
  int hits = 0;
  int larger_roots = 0;
  int tangents = 0;
  int misses = 0;
  int zeros = 0;
  int subnormal = 0;
  int overflowed = 0;
};

Counts expect_oracle_agrees(const std::vector<Case>& cases) {
  const std::vector<std::string> lines = ask_oracle(cases);
  EXPECT_EQ(lines.size(), cases.size());
  Counts counts;
  for (std::size_t k = 0; k < lines.size() && !testing::Test::HasFailure(); ++k) {
    const auto& [given, sphere] = cases[k];
    SCOPED_TRACE(spelled(given) + spelled(sphere) + " " + lines[k]);
    const Answer answer(lines[k]);
    const ExactRay ray(given);
    EXPECT_TRUE(ray.intersect(sphere, Root::kSmaller) == answer.intersection(Root::kSmaller));
    const Intersection at = ray.intersect(sphere);
    EXPECT_TRUE(at == answer.intersection(Root::kNearest));
    counts.misses += at.hit_class == HitClass::kMiss ? 1 : 0;
    if (at.hit_class == HitClass::kMiss) continue;
    const bool is_smaller = at.root == WhichRoot::kSmaller;
    const double s = is_smaller ? answer.smaller : answer.larger;
    EXPECT_EQ(ray.rounded_parameter(sphere, at), s);
    if (at.hit_class == HitClass::kHit) {
      // The other root, too, even where it lies behind the ray's origin.
      const WhichRoot other = is_smaller ? WhichRoot::kLarger : WhichRoot::kSmaller;
      EXPECT_EQ(ray.rounded_parameter(sphere, {HitClass::kHit, other}),
                is_smaller ? answer.larger : answer.smaller);
    }
    counts.hits += at.hit_class == HitClass::kHit ? 1 : 0;
    counts.tangents += at.hit_class == HitClass::kTangent ? 1 : 0;
    counts.larger_roots += is_smaller ? 0 : 1;
    counts.zeros += s == 0 ? 1 : 0;
    counts.subnormal += s > 0 && s < std::numeric_limits<double>::min() ? 1 : 0;
    counts.overflowed += std::isinf(s) ? 1 : 0;
  }
  return counts;
}

template <class Make>
Counts expect_oracle_agrees_on(int count, std::uint64_t seed, Make make) {
  Random random(seed);
  std::vector<Case> cases;
  for (int k = 0; k < count; ++k) cases.push_back(make(random));
  return expect_oracle_agrees(cases);
}

TEST(PythonOracle, AgreesOnOrdinaryRays) {
  const Counts counts = expect_oracle_agrees_on(1000, 1, [](Random& random) {
    const Ray ray = random_ray(random, Sizes::kOrdinary);
    return Case{ray, random_sphere(random, Sizes::kOrdinary)};
  });
  EXPECT_GE(counts.hits, 50);
  EXPECT_GE(counts.misses, 300);
}

TEST(PythonOracle, AgreesOnNearTies) {
  // Beside a tangent line, or at the surface: 1 + a few ulps from (-5, 0, 0), along x, and scaled.
  const Counts counts = expect_oracle_agrees_on(1000, 2, [](Random& random) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.integer(-60, 60)));
    const double edge = nudged(1, random.integer(-3, 3)) * scale;
    const Ray ray = random.one_in(2)
                        ? Ray{{-5 * scale, edge, 0}, {3, 0, 0}}
                        : Ray{{edge, 0, 0}, {random.sign(), random.small_integer(1), 0}};
    return Case{ray, {{0, 0, 0}, nudged(1, random.integer(-3, 3)) * scale}};
  });
  EXPECT_GE(counts.hits, 200);
  EXPECT_GE(counts.larger_roots, 100);
  EXPECT_GE(counts.tangents, 40);
  EXPECT_GE(counts.misses, 200);
  EXPECT_GE(counts.zeros, 40);
}

TEST(PythonOracle, AgreesOnTheWholeRange) {
  const Counts counts = expect_oracle_agrees_on(2500, 3, [](Random& random) {
    const Ray ray = random_ray(random, Sizes::kAll);
    return Case{ray, random_sphere(random, Sizes::kAll)};
  });
  EXPECT_GE(counts.hits, 200);
  EXPECT_GE(counts.misses, 200);
  EXPECT_GE(counts.subnormal, 3);
  EXPECT_GE(counts.overflowed, 10);
}

}  // namespace
}  // namespace raycheck::reference
