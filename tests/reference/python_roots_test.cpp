// Which roots count, against tests/reference/roots_oracle.py, which knows only Python's fractions:
// ends at, just below and just above exact roots.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "reference/exact_ray.h"
#include "scene/number.h"
#include "tests/numbers.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

struct Asked {
  scene::Ray ray;
  scene::Sphere sphere;
  scene::Conventions conventions;
};

/// Small integers, so that roots are often doubles, or ordinary numbers; ends beside the roots.
Asked asked(Random& random) {
  Asked one;
  const auto whole = [&](int most) { return static_cast<double>(random.integer(-most, most)); };
  if (random.one_in(2)) {
    one.ray = {{whole(5), 0, 0}, {random.sign() * static_cast<double>(random.integer(1, 3)), 0, 0}};
    one.sphere = {{whole(5), whole(2), 0}, static_cast<double>(random.integer(0, 4))};
  } else {
    one.ray = random_ray(random, Sizes::kOrdinary);
    one.sphere = random_sphere(random, Sizes::kOrdinary);
  }
  scene::ValidRoots& valid = one.conventions.valid;
  valid.ends = static_cast<scene::Ends>(random.integer(0, 3));
  valid.unit = static_cast<scene::TUnit>(random.integer(0, 1));
  valid.culling = static_cast<scene::Culling>(random.integer(0, 2));
  const bool front = valid.culling == scene::Culling::kFrontFaces;
  if (!front && random.one_in(4)) one.conventions.root = scene::Root::kSmaller;
  const ExactRay exact(one.ray);
  const auto end_near = [&](WhichRoot root) {
    Intersection at = exact.intersect(one.sphere);
    if (at.hit_class == HitClass::kMiss) return std::abs(whole(5));
    at.root = root;
    double s = std::abs(exact.rounded_parameter(one.sphere, at));
    if (valid.unit == scene::TUnit::kRadius && one.sphere.radius > 0) s /= one.sphere.radius;
    return s == 0 ? 0 : nudged(s, random.integer(-1, 1));
  };
  valid.t_min =
      random.one_in(4) ? 0 : end_near(random.one_in(2) ? WhichRoot::kSmaller : WhichRoot::kLarger);
  if (!random.one_in(2)) valid.t_max = std::max(valid.t_min, end_near(WhichRoot::kLarger));
  return one;
}

std::string line_of(const Asked& one) {
  constexpr const char* kEnds[] = {"[]", "[)", "(]", "()"};
  std::string line;
  const auto& [o, d] = one.ray;
  const auto& [c, r] = one.sphere;
  const scene::ValidRoots& valid = one.conventions.valid;
  for (const double x : {o.x, o.y, o.z, d.x, d.y, d.z, c.x, c.y, c.z, r, valid.t_min}) {
    line += scene::hexfloat(x) + " ";
  }
  line += std::isinf(valid.t_max) ? "inf" : scene::hexfloat(valid.t_max);
  return line + " " + kEnds[static_cast<int>(valid.ends)] + " " + std::string(name(valid.unit)) +
         " " + std::string(name(valid.culling)) + " " + std::string(name(one.conventions.root));
}

TEST(PythonRoots, CountAsFractionsSay) {
  const std::string base =
      (std::filesystem::temp_directory_path() / ("raycheck_" + std::to_string(getpid()) + "_roots"))
          .string();
  Random random(11);
  std::vector<Asked> all;
  {
    std::ofstream out(base + ".in");
    for (int k = 0; k < 6000; ++k) {
      all.push_back(asked(random));
      out << line_of(all.back()) << '\n';
    }
  }
  const std::string command = "python3 '" RAYCHECK_SOURCE_DIR
                              "/tests/reference/roots_oracle.py' < '" +
                              base + ".in' > '" + base + ".out'";
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream in(base + ".out");
  int misses = 0, near = 0, far = 0, tangents = 0, at_end = 0, mutants = 0;
  for (const Asked& one : all) {
    std::string line;
    ASSERT_TRUE(std::getline(in, line));
    const ExactRay ray(one.ray);
    const auto text = [&](const scene::Conventions& conventions) -> std::string {
      const Intersection at = ray.intersect(one.sphere, conventions);
      if (at.hit_class == HitClass::kMiss) return "miss";
      return std::string(at.hit_class == HitClass::kTangent ? "tangent " : "hit ") +
             (at.root == WhichRoot::kSmaller ? "near" : "far");
    };
    ASSERT_EQ(text(one.conventions), line) << line_of(one);
    misses += line == "miss" ? 1 : 0;
    near += line == "hit near" ? 1 : 0;
    far += line == "hit far" ? 1 : 0;
    tangents += line.starts_with("tangent") ? 1 : 0;
    // < for <= is another answer where a root is an end.
    scene::Conventions open = one.conventions, closed = one.conventions;
    open.valid.ends = scene::Ends::kOpen;
    closed.valid.ends = scene::Ends::kClosed;
    at_end += text(open) != text(closed) ? 1 : 0;
    mutants += text(open) != line ? 1 : 0;
  }
  EXPECT_GE(misses, 1000);
  EXPECT_GE(near, 200);
  EXPECT_GE(far, 200);
  EXPECT_GE(tangents, 30);
  EXPECT_GE(at_end, 100);
  EXPECT_GE(mutants, 50);
  std::filesystem::remove(base + ".in");
  std::filesystem::remove(base + ".out");
}

}  // namespace
}  // namespace raycheck::reference
