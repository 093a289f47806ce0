// Compares answers for given rays and spheres with tests/reference/oracle.py, which uses only
// Python's integers and fractions: the root that is met, under every convention, and the doubles
// nearest to both roots.

#include <unistd.h>

#include "reference/exact_ray.h"
#include "scene/number.h"
#include "tests/library/shell.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Ray;

struct Asked {
  Ray ray;
  scene::Sphere sphere;
  scene::Conventions conventions = {};
};

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

/// The oracle's answers, one line per case; fails if it cannot be run.
std::vector<std::string> ask_oracle(const std::vector<Asked>& cases) {
  const std::string asked = testing::TempDir() + "raycheck_" + std::to_string(getpid()) + "_oracle";
  {
    std::ofstream out(asked);
    for (const Asked& one : cases) out << line_of(one) << '\n';
  }
  const tests::Ended ended =
      tests::shell("python3 '" RAYCHECK_SOURCE_DIR "/tests/reference/oracle.py' < '" + asked + "'");
  EXPECT_EQ(ended.code, 0) << "python3 is needed: " << ended.text;
  std::filesystem::remove(asked);
  return lines_of(ended.text);
}

/// "miss", or "hit near" and the like.
std::string met(const ExactRay& ray, const Asked& one, const scene::Conventions& conventions) {
  const Intersection at = ray.intersect(one.sphere, conventions);
  if (at.hit_class == HitClass::kMiss) return "miss";
  return std::string(at.hit_class == HitClass::kTangent ? "tangent " : "hit ") +
         (at.root == WhichRoot::kSmaller ? "near" : "far");
}

/// The number of answers, or of values of s, of each kind.
using Counts = std::map<std::string, int>;

template <class Make>
Counts expect_oracle_agrees(int count, std::uint64_t seed, Make make) {
  Random random(seed);
  std::vector<Asked> cases;
  for (int k = 0; k < count; ++k) cases.push_back(make(random));
  const std::vector<std::string> lines = ask_oracle(cases);
  EXPECT_EQ(lines.size(), cases.size());
  Counts counts;
  for (std::size_t k = 0; k < lines.size() && !testing::Test::HasFailure(); ++k) {
    const Asked& one = cases[k];
    SCOPED_TRACE(line_of(one) + ": " + lines[k]);
    const ExactRay ray(one.ray);
    std::istringstream in(lines[k]);
    std::string answer, which, smaller, larger;
    if (in >> answer >> which >> smaller >> larger) answer += " " + which;
    EXPECT_EQ(met(ray, one, one.conventions), answer);
    ++counts[answer];
    // If a root is equal to an end, open and closed ends give different answers.
    scene::Conventions open = one.conventions, closed = one.conventions;
    open.valid.ends = scene::Ends::kOpen;
    closed.valid.ends = scene::Ends::kClosed;
    counts["at an end"] += met(ray, one, open) != met(ray, one, closed) ? 1 : 0;
    if (answer == "miss") continue;
    // Both roots are compared, even if the other root does not count.
    const HitClass hit_class = ray.intersect(one.sphere, one.conventions).hit_class;
    for (const auto& [root, text] :
         {std::pair(WhichRoot::kSmaller, smaller), {WhichRoot::kLarger, larger}}) {
      const double s = std::strtod(text.c_str(), nullptr);
      EXPECT_EQ(ray.rounded_parameter(one.sphere, {hit_class, root}), s);
      counts["zero"] += s == 0 ? 1 : 0;
      counts["subnormal"] += s > 0 && s < kSmallestNormal ? 1 : 0;
      counts["overflowed"] += std::isinf(s) ? 1 : 0;
    }
  }
  return counts;
}

void expect_at_least(const Counts& counts, const Counts& least) {
  for (const auto& [kind, most] : least) {
    const auto at = counts.find(kind);
    EXPECT_GE(at == counts.end() ? 0 : at->second, most) << kind;
  }
}

TEST(PythonOracle, AgreesOnNearTies) {
  // Near a tangent line or at the surface: a few ulps off, from (-5, 0, 0) along x, and scaled.
  const Counts counts = expect_oracle_agrees(1000, 2, [](Random& random) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.integer(-60, 60)));
    const double edge = nudged(1, random.integer(-3, 3)) * scale;
    const Ray ray = random.one_in(2)
                        ? Ray{{-5 * scale, edge, 0}, {3, 0, 0}}
                        : Ray{{edge, 0, 0}, {random.sign(), random.small_integer(1), 0}};
    return Asked{ray, {{0, 0, 0}, nudged(1, random.integer(-3, 3)) * scale}};
  });
  expect_at_least(
      counts,
      {{"hit near", 100}, {"hit far", 100}, {"tangent near", 40}, {"miss", 200}, {"zero", 40}});
}

TEST(PythonOracle, AgreesOnTheWholeRange) {
  const Counts counts = expect_oracle_agrees(2500, 3, [](Random& random) {
    const Ray ray = random_ray(random, Sizes::kAll);
    Asked one{ray, random_sphere(random, Sizes::kAll)};
    if (random.one_in(2)) one.conventions.root = scene::Root::kSmaller;
    return one;
  });
  expect_at_least(
      counts,
      {{"hit near", 50}, {"hit far", 50}, {"miss", 200}, {"subnormal", 3}, {"overflowed", 10}});
}

/// Small integers, so that roots are often doubles, or ordinary numbers. Ends are close to the
/// roots.
Asked with_ends(Random& random) {
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

TEST(PythonOracle, AgreesWhichRootsCount) {
  expect_at_least(
      expect_oracle_agrees(3000, 11, with_ends),
      {{"miss", 500}, {"hit near", 75}, {"hit far", 75}, {"tangent near", 15}, {"at an end", 50}});
}

}  // namespace
}  // namespace raycheck::reference
