// Tests what the method `robust` promises for every valid input: no wrong hit class, and no s that
// is off by more than kRobust.max_ulp.

#include "fast/internal/robust.h"

#include <hwy/targets.h>

#include "fast/intersect.h"
#include "properties/cases/case_source.h"
#include "properties/cases/random.h"
#include "reference/error_measure.h"
#include "reference/exact_ray.h"
#include "scene/validate.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::fast {
namespace {

using properties::Random;
using reference::HitClass;
using reference::numbers_of;
using namespace scene;

/// Counts comparisons, so that no test passes for lack of cases.
struct RobustAudit {
  int pairs = 0, hits = 0, tangents = 0, subnormal = 0, overflows = 0, wrong_classes = 0;
  double worst_s = 0;
  std::string worst;  ///< The case of worst_s or of the last wrong class.
};

using Answer = std::optional<Hit> (*)(const Ray&, const Sphere&, HitRule);

void compare(Answer answer, const Ray& ray, const Sphere& sphere, HitRule rule,
             RobustAudit& audit) {
  if (!scene::defects(ray).empty() || !scene::defects(sphere).empty()) return;
  const reference::ExactRay exact(ray);
  const reference::Intersection at = exact.intersect(sphere, rule.root);
  const auto hit = answer(ray, sphere, rule);
  ++audit.pairs;
  audit.tangents += at.hit_class == HitClass::kTangent ? 1 : 0;
  if (hit.has_value() != reference::counts_as_hit(at.hit_class, rule.tangent)) {
    ++audit.wrong_classes;
    audit.worst = reference::spelled(ray) + reference::spelled(sphere);
  }
  if (!hit || at.hit_class == HitClass::kMiss) return;
  ++audit.hits;
  const double rounded = exact.rounded_parameter(sphere, at);
  audit.subnormal += rounded != 0 && rounded < kSmallestNormal ? 1 : 0;
  double error = 0;
  if (!std::isfinite(rounded)) {
    ++audit.overflows;
    error = hit->parameter == kInfinity ? 0 : kInfinity;
  } else if (hit->parameter != rounded) {
    error = reference::ulp_error(hit->parameter, exact.parameter(sphere, at)).value;
  }
  if (error > audit.worst_s) {
    audit.worst_s = error;
    audit.worst = reference::spelled(ray) + reference::spelled(sphere);
  }
}

/// Compares under every convention that can matter.
void compare_all(Answer answer, const Ray& ray, const Sphere& sphere, RobustAudit& audit) {
  compare(answer, ray, sphere, {Root::kNearest, Tangent::kHit}, audit);
  compare(answer, ray, sphere, {Root::kNearest, Tangent::kMiss}, audit);
  compare(answer, ray, sphere, {Root::kSmaller, Tangent::kHit}, audit);
}

void expect_kept(const RobustAudit& audit, int least_pairs, int least_hits) {
  EXPECT_EQ(audit.wrong_classes, 0) << audit.worst;
  EXPECT_LE(audit.worst_s, kRobust.max_ulp) << audit.worst;
  EXPECT_GE(audit.pairs, least_pairs);
  EXPECT_GE(audit.hits, least_hits);
}

void scale_anywhere(Random& random, Ray& ray, Sphere& sphere) {
  const auto factor = [&] {
    return random.one_in(2) ? 0 : static_cast<int>(random.integer(-1074, 1015));
  };
  const int lengths = factor(), direction = factor();
  for (double* x : numbers_of(ray.origin)) *x = std::ldexp(*x, lengths);
  for (double* x : numbers_of(sphere.centre)) *x = std::ldexp(*x, lengths);
  sphere.radius = std::ldexp(sphere.radius, lengths);
  for (double* x : numbers_of(ray.direction)) *x = std::ldexp(*x, direction);
}

/// The number of cases of each source: 20,000, or RAYCHECK_ROBUST_CASES (a million at night).
std::uint64_t cases_of_each_source() {
  const char* const asked = std::getenv("RAYCHECK_ROBUST_CASES");
  return asked == nullptr ? 20000 : std::stoull(asked);
}

TEST(Robust, IsRightOnEverySourceOfGivenRays) {
  RobustAudit audit;
  const std::uint64_t cases = cases_of_each_source();
  for (const properties::CaseSource& source : properties::case_sources()) {
    if (source.has_camera) continue;
    const int before = audit.hits;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
      const auto the_case = properties::ChosenSource{&source}.make(seed);
      const scene::Conventions& conventions = the_case.scene.conventions;
      for (const Sphere& sphere : the_case.scene.spheres) {
        compare(kRobust.intersect_one, the_case.scene.rays.front(), sphere, conventions.hit_rule(),
                audit);
      }
    }
    EXPECT_GT(audit.hits - before, 5000) << source.name;
  }
  expect_kept(audit, 200000, 80000);
  EXPECT_GT(audit.tangents, 2000);
  EXPECT_GT(audit.subnormal, 100);
  EXPECT_GT(audit.overflows, 500);
}

/// Small integers: tangents, origins on the surface and at the centre, points for spheres.
void small_integers(Random& random, Ray& ray, Sphere& sphere) {
  for (double* x : numbers_of(ray.origin)) *x = random.small_integer(4);
  for (double* x : numbers_of(ray.direction)) *x = random.small_integer(4);
  for (double* x : numbers_of(sphere.centre)) *x = random.small_integer(4);
  sphere.radius = static_cast<double>(random.integer(0, 5));
}

/// Pythagorean numbers: exact tangents, and origins on the surface that are not on an axis.
void pythagorean(Random& random, Ray& ray, Sphere& sphere) {
  const double way = random.small_integer(1000);
  const auto place = [&](const scene::Vector3& v) { return scene::Point3{v.x, v.y, v.z}; };
  if (random.one_in(3)) {  // c = 25 step^2: near the surface, nearer than T's last bit
    const double step = std::ldexp(1.0, -static_cast<int>(random.integer(20, 300)));
    sphere = {{3, 4, 0}, 5};
    ray.origin = place({-4 * step, 3 * step, 0});
    ray.direction = {random.small_integer(9), random.small_integer(9), random.small_integer(2)};
  } else if (random.one_in(2)) {  // the normal (2, 3, 6)/7, along (3, -2, 0) or (6, 0, -2)
    const double radius = 7 * static_cast<double>(random.integer(1, 1000));
    sphere = {{0, 0, 0}, radius};
    ray.direction = random.one_in(2) ? scene::Vector3{3, -2, 0} : scene::Vector3{6, 0, -2};
    const double n = radius / 7;
    ray.origin = place({2 * n + way * ray.direction.x, 3 * n + way * ray.direction.y,
                        6 * n + way * ray.direction.z});
  } else {  // on the surface, in any direction
    sphere = {{0, 0, 0}, 5};
    ray.origin = random.one_in(2) ? place({3, 4, 0}) : place({0, -4, 3});
    ray.direction = {random.small_integer(9), random.small_integer(9), random.small_integer(9)};
  }
}

TEST(Robust, IsRightOnTangentsAndSurfacesAndTheirNeighbours) {
  Random random(1);
  RobustAudit audit;
  for (int k = 0; k < 30000; ++k) {
    Ray ray;
    Sphere sphere;
    random.one_in(2) ? small_integers(random, ray, sphere) : pythagorean(random, ray, sphere);
    if (random.one_in(2)) {
      for (double* x : {&ray.origin.x, &ray.origin.y, &ray.origin.z, &ray.direction.x,
                        &ray.direction.y, &ray.direction.z, &sphere.radius}) {
        if (random.one_in(4)) *x = reference::nudged(*x, random.integer(-2, 2));
      }
    }
    scale_anywhere(random, ray, sphere);
    compare_all(kRobust.intersect_one, ray, sphere, audit);
  }
  expect_kept(audit, 70000, 20000);
  EXPECT_GT(audit.tangents, 3000);
}

/// A double of any size. The exponents of a case are all over the range, or close to each other.
double any_double(Random& random, std::int64_t middle, std::int64_t spread) {
  if (random.one_in(8)) return 0;
  const auto exponent = middle + random.integer(-spread, spread);
  const double significand =
      random.one_in(2) ? random.between(1, 2) : static_cast<double>(random.integer(1, 8));
  return random.sign() * std::ldexp(significand, static_cast<int>(exponent));
}

TEST(Robust, IsRightOnComponentsOfAnyExponents) {
  Random random(2);
  RobustAudit audit;
  for (int k = 0; k < 40000; ++k) {
    const std::int64_t spreads[] = {0, 3, 30, 60, 300, 1000};
    const std::int64_t spread = spreads[random.integer(0, 5)];
    const std::int64_t middle = random.one_in(2) ? 0 : random.integer(-1000, 950);
    const std::int64_t direction_middle = random.one_in(2) ? 0 : random.integer(-1000, 950);
    Ray ray;
    Sphere sphere;
    for (double* x : numbers_of(ray.origin)) *x = any_double(random, middle, spread);
    for (double* x : numbers_of(sphere.centre)) *x = any_double(random, middle, spread);
    for (double* x : numbers_of(ray.direction)) *x = any_double(random, direction_middle, spread);
    sphere.radius = random.one_in(8) ? 0 : std::abs(any_double(random, middle + 2, spread));
    if (random.one_in(8)) ray.origin = sphere.centre;
    compare_all(kRobust.intersect_one, ray, sphere, audit);
  }
  expect_kept(audit, 80000, 20000);
  EXPECT_GT(audit.subnormal, 50);
  EXPECT_GT(audit.overflows, 300);
}

/// If a step answers a case that is given exactly, it must be right.
TEST(Robust, IsRightInEachOfItsSteps) {
  const Answer integers = [](const Ray& ray, const Sphere& sphere, HitRule rule) {
    return answer_by_integers(ray, sphere, rule).if_hit();
  };
  static int proven = 0;
  const Answer pairs = [](const Ray& ray, const Sphere& sphere, HitRule rule) {
    const auto chosen = answer_by_pairs(ray, sphere, rule.root);
    if (!chosen) return kRobust.intersect_one(ray, sphere, rule);
    ++proven;
    return chosen->if_hit();
  };
  RobustAudit by_integers;
  RobustAudit by_pairs;
  for (const properties::CaseSource& source : properties::case_sources()) {
    if (source.has_camera) continue;
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
      const auto the_case = properties::ChosenSource{&source}.make(seed);
      const scene::Conventions& conventions = the_case.scene.conventions;
      const Ray& ray = the_case.scene.rays.front();
      const Sphere& sphere = the_case.scene.spheres.front();
      compare(integers, ray, sphere, conventions.hit_rule(), by_integers);
      compare(pairs, ray, sphere, conventions.hit_rule(), by_pairs);
    }
  }
  expect_kept(by_integers, 20000, 8000);
  expect_kept(by_pairs, 20000, 8000);
  // Not proven: exact tangents, and origins exactly on the surface.
  EXPECT_GT(proven, by_pairs.pairs * 8 / 10);
}

/// A sphere with a centre up to 2^26 radii from the world's origin.
Sphere some_sphere(Random& random) {
  const double radius = std::exp2(random.between(-10, 10));
  const double reach = random.one_in(3) ? 0 : radius * std::exp2(random.between(-4, 26));
  const scene::Vector3 place = random.direction();
  return {{reach * place.x, reach * place.y, reach * place.z}, radius};
}

/// Rays around the margins of the first step: rays that start near the surface, inside or up to
/// 2^17 radii away, and grazing rays.
Ray near_margins(Random& random, const Sphere& sphere) {
  const double far = std::exp2(random.between(0, 17));
  const double beside =
      1 + random.sign() * std::exp2(random.between(random.one_in(2) ? -28 : -40, 0));
  const double x = random.one_in(3) ? far : random.one_in(4) ? random.between(0, 1) : beside;
  const double t = std::exp2(random.between(random.one_in(2) ? -15 : -30, 0));
  const double sine = std::min(1.0, std::sqrt(1 - t) / x);
  const double cosine = random.sign() * std::sqrt(1 - sine * sine);
  const double length = std::exp2(random.between(-3, 3));
  const scene::Vector3 in = random.direction(), other = random.direction();
  const double along = other.x * in.x + other.y * in.y + other.z * in.z;
  const double width = std::sqrt(1 - along * along);
  const auto origin = [&](double centre, double to) { return centre - x * sphere.radius * to; };
  const auto aim = [&](double to, double aside) {
    return length * (cosine * to + sine * (aside - along * to) / width);
  };
  return {
      {origin(sphere.centre.x, in.x), origin(sphere.centre.y, in.y), origin(sphere.centre.z, in.z)},
      {aim(in.x, other.x), aim(in.y, other.y), aim(in.z, other.z)}};
}

/// s is off by hardly more than its rounding (0.62 ulp by the first step's proof), and batches have
/// the answers of single calls.
TEST(Robust, IsRightNearItsMarginsOnEveryTarget) {
  constexpr double kSeenUlp = 0.505;
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
    SCOPED_TRACE(hwy::TargetName(left & -left));
    hwy::SetSupportedTargetsForTest(left & -left);
    Random random(3);
    RobustAudit audit;
    for (int k = 0; k < 2000; ++k) {
      const Sphere sphere = some_sphere(random);
      const HitRule rule = {random.one_in(2) ? Root::kNearest : Root::kSmaller};
      Rays rays;
      rays.resize(101);
      for (std::size_t ray = 0; ray < rays.size(); ++ray) {
        rays.set(ray, near_margins(random, sphere));
        compare(kRobust.intersect_one, rays.at(ray), sphere, rule, audit);
      }
      Hits hits;
      kRobust.intersect(rays, sphere, rule, hits);
      for (std::size_t ray = 0; ray < rays.size(); ++ray) {
        const auto single = kRobust.intersect_one(rays.at(ray), sphere, rule);
        ASSERT_EQ(single.has_value(), hits.hit[ray] == 1);
        if (!single) continue;
        ASSERT_EQ(single->parameter, hits.parameter[ray]);
        ASSERT_EQ(single->point, hits.point.at<scene::Point3>(ray));
      }
    }
    hwy::SetSupportedTargetsForTest(0);
    expect_kept(audit, 200000, 80000);
    EXPECT_LE(audit.worst_s, kSeenUlp) << audit.worst;
  }
}

TEST(Robust, MissesOnInvalidInput) {
  for (const Ray& ray : {Ray{{kNaN, 0, 0}, {1, 0, 0}}, Ray{{0, 0, 0}, {0, 0, 0}},
                         Ray{{0, 0, 0}, {kInfinity, 0, 0}}, Ray{{kInfinity, 0, 0}, {1, 0, 0}}}) {
    EXPECT_FALSE(kRobust.intersect_one(ray, reference::kUnit, {}));
  }
}

}  // namespace
}  // namespace raycheck::fast
