// Compares errors with values by hand, rational arithmetic and balls.

#include "reference/error_measure.h"

#include <boost/multiprecision/gmp.hpp>

#include "reference/exact_ray.h"
#include "reference/ray_error.h"
#include "tests/reference/big_float.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using scene::Ray;
using scene::Sphere;

Enclosure real(double x) { return Enclosure(x, 192); }
Enclosure3 real3(double x, double y, double z) { return {real(x), real(y), real(z)}; }

struct UlpCase {
  const char* what;
  double given;
  Enclosure exact;
  double ulp;
  scene::Precision precision = scene::Precision::kDouble;
};

TEST(UlpError, IsCountedInGapsAroundTheTruth) {
  constexpr auto kSingle = scene::Precision::kSingle;
  const Enclosure between = real(1.5) + real(0x1p-54), below_all = real(kSmallest) * real(0.25);
  for (const auto& [what, given, exact, ulp, precision] : std::vector<UlpCase>{
           {"none", 1, real(1), 0},
           {"of a negative", nudged(-1.5, 3), real(-1.5), 3},
           {"of no double, below", 1.5, between, 0.25},
           {"of no double, above", nudged(1.5, 1), between, 0.75},
           {"above a power of two", nudged(1, 1), real(1), 1},
           {"below it, where doubles are nearer", nudged(1, -1), real(1), 0.5},
           {"of what is below it", 1, real(1) - real(0x1p-54), 0.5},
           {"of subnormals", 0, real(5 * kSmallest), 5},
           {"below the normal ones", nudged(kSmallestNormal, -2), real(kSmallestNormal), 2},
           {"of less than any", 0, below_all, 0.25},
           {"of less than any, above", kSmallest, below_all, 0.75},
           {"of a zero", -0.0, real(0), 0},
           {"of a zero, missed", kSmallest, real(0), kInfinity},
           {"at the end of the range", nudged(kLargest, -1), real(kLargest), 1},
           {"of the wrong sign", -1, real(1), 0x1p53},
           {"too many to count", 1, real(kSmallest), kInfinity},
           {"infinite", kInfinity, real(kLargest), kInfinity},
           {"no number", kNaN, real(1), kInfinity},
           {"of a truth without bounds", 1, Enclosure(1) / Enclosure(0), kInfinity},
           {"of a float", 1 + 0x1p-23, real(1), 1, kSingle},
           {"below a power of two of floats", 1 - 0x1p-24, real(1), 0.5, kSingle},
           {"of no float", 3, real(3 + 0x1p-24), 0.25, kSingle},
           {"of subnormal floats", 0, real(0x1p-140), 0x1p9, kSingle},
           {"of less than any float", 0x1p-149, real(0x1p-151), 0.75, kSingle},
           {"below the normal floats", 0x1p-126, real(0x1p-126 - 0x1p-149), 1, kSingle},
           {"at twice the least of these", 0x1p-125, real(0x1p-125 + 0x1p-148), 1, kSingle}}) {
    EXPECT_EQ(ulp_error(given, exact, precision).value, ulp) << what;
  }
}

TEST(UlpError, IsAnUpperBoundThatANarrowEnclosureMakesSharp) {
  Random random(1);
  for (int k = 0; k < 3000; ++k) {
    const double truth = any_double(random);
    if (truth == 0 || std::abs(truth) == kLargest) continue;
    const double given = nudged(truth, random.integer(-9, 9));
    const Enclosure ball = Enclosure::within(truth, 0x1p-80, 256);
    const Big magnitude = abs(Big(truth));
    int exponent = 0;
    (void)std::frexp(truth, &exponent);
    const Big error = abs(Big(given) - Big(truth)) / power_of_two(std::max(exponent - 53, -1074));
    const double bound = ulp_error(given, ball).value;
    ASSERT_GE(Big(bound), error) << scene::hexfloat(truth);
    // The enclosure of a power of two contains smaller numbers, where the gap is half as wide.
    const bool is_power_of_two = magnitude == power_of_two(exponent - 1);
    ASSERT_LE(Big(bound), error * (is_power_of_two ? 2 : 1) + power_of_two(-25));
  }
}

TEST(RelativeError, IsTheDistanceOverTheLengthInUnitsOfU) {
  // (3, 4, 0) is 5 long; moved by 2^-50 along z.
  const double expected = 0x1p-50 / 5 * 0x1p53;
  const double error = relative_error(scene::Point3{3, 4, 0x1p-50}, real3(3, 4, 0)).value;
  EXPECT_GE(error, expected * (1 - 1e-15));
  EXPECT_LE(error, expected * (1 + 1e-15));
  EXPECT_EQ(relative_error(scene::Point3{3, 4, 12}, real3(3, 4, 12)).value, 0);
  EXPECT_EQ(relative_error(scene::UnitVector3{1, 0, 0x1p-53}, real3(1, 0, 0)).value, 1);
}

TEST(RelativeError, OfTheOriginIsZeroOrInfinite) {
  EXPECT_EQ(relative_error(scene::Point3{0, 0, 0}, real3(0, 0, 0)).value, 0);
  EXPECT_EQ(relative_error(scene::Point3{0, kSmallest, 0}, real3(0, 0, 0)).value, kInfinity);
  EXPECT_EQ(relative_error(scene::Point3{0, kNaN, 0}, real3(1, 0, 0)).value, kInfinity);
  EXPECT_EQ(relative_error(scene::Point3{kInfinity, 0, 0}, real3(1, 0, 0)).value, kInfinity);
}

TEST(RelativeError, OfDoublesIsThatOfTheirEnclosures) {
  const scene::UnitVector3 exact = {0.6, -0.8, 0};
  for (const scene::UnitVector3& given :
       {exact, scene::UnitVector3{0.6, -0.8, 0x1p-53}, scene::UnitVector3{0, 0, 0},
        scene::UnitVector3{kNaN, -0.8, 0}, scene::UnitVector3{kInfinity, -0.8, 0}}) {
    const double error = relative_error(given, real3(exact.x, exact.y, exact.z)).value;
    EXPECT_EQ(relative_error(given, exact).value, error);
  }
  const scene::UnitVector3 infinite = {kInfinity, 0, 0};
  EXPECT_EQ(relative_error(infinite, infinite).value, kInfinity);
}

TEST(AngleError, IgnoresLengthAndIsInfiniteFromARightAngleOn) {
  EXPECT_EQ(angle_error({1.2, 1.6, 0}, real3(0.6, 0.8, 0)).value, 0);
  const Enclosure3 along_x = real3(1, 0, 0);
  EXPECT_EQ(angle_error({1, 0x1p-53, 0}, along_x).value, 1);
  EXPECT_EQ(angle_error({2, 0x1p-52, 0}, along_x).value, 1);
  EXPECT_LT(angle_error({1, 1000, 0}, along_x).value, 1001 * 0x1p53);
  for (const scene::UnitVector3& given :
       {scene::UnitVector3{0, 1, 0}, {-1, 0, 0}, {0, 0, 0}, {kNaN, 0, 0}}) {
    EXPECT_EQ(angle_error(given, along_x).value, kInfinity) << given.x;
  }
}

TEST(UnitDefect, IsTheDistanceOfTheLengthFromOne) {
  EXPECT_EQ(unit_defect({1, 0, 0}).value, 0);
  EXPECT_EQ(unit_defect({0, -2, 0}).value, 0x1p53);
  EXPECT_EQ(unit_defect({0, 0, 0}).value, 0x1p53);
  for (const auto& [z, exact] : {std::pair(nudged(1, 1), 2.0), {nudged(1, -1), 1.0}}) {
    EXPECT_GE(unit_defect({0, 0, z}).value, exact);
    EXPECT_LE(unit_defect({0, 0, z}).value, exact * (1 + kUnitDefectWidth));
  }
  EXPECT_EQ(unit_defect({0, kInfinity, 0}).value, kInfinity);
  // 0.6 and 0.8 are rounded, so that the sum of their squares is not exactly 1.
  const Big length = sqrt(Big(0.6) * Big(0.6) + Big(0.8) * Big(0.8));
  const Big expected = abs(length - 1) * power_of_two(53);
  const double defect = unit_defect({0.6, 0.8, 0}).value;
  EXPECT_GE(Big(defect), expected);
  EXPECT_LE(Big(defect), expected * (1 + kUnitDefectWidth));
}

TEST(InUnitsOfU, BoundsFromAbove) {
  EXPECT_EQ(in_units_of_u(real(-0x1p-53)).value, 1);
  EXPECT_EQ(in_units_of_u(real(0)).value, 0);
  EXPECT_EQ(in_units_of_u(real(kLargest)).value, kInfinity);
  EXPECT_EQ(in_units_of_u(Enclosure(1) / Enclosure(0)).value, kInfinity);
}

using Fraction = boost::multiprecision::mpq_rational;

/// |p| / (2 sum_k |q_k| (|L_k| + |C_k| + |s d_k|) + 2 r^2) in units of u; 0 where p = 0.
Fraction exact_backward_error(const Ray& ray, const Sphere& sphere, double parameter) {
  const std::array<std::array<double, 3>, 3> coordinates = {{
      {ray.origin.x, ray.direction.x, sphere.centre.x},
      {ray.origin.y, ray.direction.y, sphere.centre.y},
      {ray.origin.z, ray.direction.z, sphere.centre.z},
  }};
  const Fraction r(sphere.radius);
  Fraction p = -r * r;
  Fraction change = 2 * r * r;
  for (const auto& [origin, direction, centre] : coordinates) {
    const Fraction step = Fraction(parameter) * Fraction(direction);
    const Fraction q = Fraction(origin) + step - Fraction(centre);
    p += q * q;
    change += 2 * abs(q) * (abs(Fraction(origin)) + abs(Fraction(centre)) + abs(step));
  }
  if (p == 0) return 0;
  return abs(p) / change * Fraction(0x1p53);
}

void expect_exact(const Ray& ray, const Sphere& sphere, double parameter) {
  const double got = backward_error(ray, sphere, parameter).value;
  const Fraction exact = exact_backward_error(ray, sphere, parameter);
  const std::string what = spelled(ray) + spelled(sphere) + " at " + scene::hexfloat(parameter);
  ASSERT_TRUE(std::isfinite(got)) << what;
  EXPECT_GE(Fraction(got), exact) << what;
  EXPECT_LE(Fraction(got), exact * Fraction(1 + kBackwardErrorWidth) + Fraction(kSmallest)) << what;
  EXPECT_EQ(got == 0, exact == 0) << what;
}

const Ray kAlongX{{-5, 0, 0}, {1, 0, 0}};

TEST(BackwardError, IsExactWhereItIsSpecial) {
  struct Place {
    const char* what;
    Ray ray;
    Sphere sphere;
    double s;
  };
  const Ray at_zero{{0, 0, 0}, {1, 0, 0}}, touching{{-5, 1, 0}, {1, 0, 0}};
  for (const auto& [what, ray, sphere, s] : std::vector<Place>{
           {"a near root", kAlongX, kUnit, 4},
           {"a far root", kAlongX, kUnit, 6},
           {"behind the ray", {{5, 0, 0}, {1, 0, 0}}, kUnit, -4},
           {"a double root", touching, kUnit, 5},
           {"beside a double root", touching, kUnit, 5 + 0x1p-20},
           {"next to a double root", touching, kUnit, 5 - 0x1p-50},
           {"a point", kAlongX, {{3, 0, 0}, 0}, 8},
           {"a far point", at_zero, {{0x1p1000, 0, 0}, 0}, 0x1p1000},
           {"a subnormal point", {{0, 0, 0}, {kSmallest, 0, 0}}, {{kSmallest, 0, 0}, 0}, 1},
           {"beside a root", kAlongX, kUnit, 4 + 0x1p-10},
           {"the most", kAlongX, {{0, 0, 0}, 0x1p600}, 0},
           {"the most, of a point", at_zero, {{7, 0, 0}, 0}, 0}}) {
    SCOPED_TRACE(what);
    expect_exact(ray, sphere, s);
    EXPECT_LE(backward_error(ray, sphere, s).value, kMostBackwardError);
  }
}

TEST(BackwardError, IsInfiniteForNonFiniteValuesAndRefusesInvalidInput) {
  for (const double s : {kInfinity, -kInfinity, kNaN}) {
    EXPECT_EQ(backward_error(kAlongX, kUnit, s).value, kInfinity) << s;
  }
  EXPECT_THROW(backward_error({{0, 0, 0}, {0, 0, 0}}, kUnit, 1), std::invalid_argument);
  EXPECT_THROW(backward_error(kAlongX, {{0, 0, 0}, -1}, 1), std::invalid_argument);
}

TEST(BackwardError, IsExactOnRandomCases) {
  for (const Sizes sizes : {Sizes::kOrdinary, Sizes::kAll}) {
    Random random(1);
    int hits = 0;
    for (int k = 0; k < 3000; ++k) {
      const Ray ray = random_ray(random, sizes);
      const Sphere sphere = random_sphere(random, sizes);
      if (sizes == Sizes::kAll) expect_exact(ray, sphere, any_double(random));
      const ExactRay exact(ray);
      const Intersection at = exact.intersect(sphere);
      if (at.hit_class != HitClass::kHit) continue;
      const double s = exact.rounded_parameter(sphere, at);
      if (!std::isfinite(s)) continue;
      ++hits;
      if (sizes == Sizes::kAll) {
        expect_exact(ray, sphere, s);
        continue;
      }
      expect_exact(ray, sphere, nudged(s, random.integer(-4, 4)));
      // A rounded s is the root of a ray whose direction was changed by as much, at most u.
      EXPECT_LE(backward_error(ray, sphere, s).value, 1 + 0x1p-20)
          << spelled(ray) << spelled(sphere);
    }
    EXPECT_GE(hits, 200);
  }
}

/// Balls so narrow that their width is negligible beside any error.
constexpr int kBits = 400;

/// Compares errors with those measured only by balls; counts those that are neither 0 nor infinite.
class Comparison {
 public:
  void expect_same(double error, double by_balls) {
    // Wider than both enclosures, which have at least 70 bits.
    EXPECT_NEAR(error, by_balls, 0x1p-16 + by_balls * 0x1p-29);
    if (error > 0 && std::isfinite(error)) ++measured_;
  }
  /// The bound is at least the error.
  void expect_bound(double error, double by_balls) {
    if (!std::isfinite(by_balls)) {
      EXPECT_EQ(error, by_balls);
      return;
    }
    expect_same(error, by_balls);
    EXPECT_GE(error, by_balls * (1 - 0x1p-52) - 0x1p-60);
  }
  int measured() const { return measured_; }

 private:
  int measured_ = 0;
};

template <class Triple>
Triple nudged3(Random& random, const Triple& v) {
  return {nudged(v.x, random.integer(-3, 3)), nudged(v.y, random.integer(-3, 3)),
          nudged(v.z, random.integer(-3, 3))};
}

void compare_rays(Comparison& comparison, Random& random, const ExactRay& ray) {
  if (ray.source().camera != nullptr) {
    const scene::Point3 point = nudged3(random, ray.rounded_pixel_point());
    comparison.expect_bound(pixel_point_error(ray, point).value,
                            relative_error(point, ray.pixel_point(kBits)).value);
  }
  const scene::Point3 origin = nudged3(random, ray.rounded_origin());
  comparison.expect_bound(origin_error(ray, origin).value,
                          relative_error(origin, ray.origin(kBits)).value);
  const scene::UnitVector3 direction = nudged3(random, ray.rounded_direction());
  comparison.expect_bound(direction_error(ray, direction).value,
                          angle_error(direction, ray.direction(kBits)).value);
}

void compare_hits(Comparison& comparison, Random& random, const ExactRay& ray,
                  const scene::Sphere& sphere) {
  const Intersection at = ray.intersect(sphere);
  if (at.hit_class == HitClass::kMiss) return;
  const double s = nudged(ray.rounded_parameter(sphere, at), random.integer(-3, 3));
  comparison.expect_bound(parameter_error(ray, sphere, at, s).value,
                          ulp_error(s, ray.parameter(sphere, at, kBits)).value);
  const scene::Point3 point = nudged3(random, ray.rounded_point(sphere, at));
  comparison.expect_bound(hit_point_error(ray, sphere, at, point).value,
                          relative_error(point, ray.point(sphere, at, kBits)).value);
  const Enclosure3 answer = enclose_exactly(point);
  if (const auto residual = ray_residual(ray, point)) {
    const Enclosure3 along = answer - ray.origin(kBits);
    if (!norm(along).contains_zero()) {
      comparison.expect_bound(
          residual->value,
          in_units_of_u(norm(cross(along, ray.direction(kBits))) / norm(along)).value);
    }
  }
  const auto residual = sphere_residual(sphere, point);
  ASSERT_EQ(residual.has_value(), sphere.radius != 0);
  if (!residual) return;
  const Enclosure radius(sphere.radius, kBits);
  comparison.expect_bound(
      residual->value,
      in_units_of_u((norm(answer - enclose_exactly(sphere.centre)) - radius) / radius).value);
}

TEST(RayError, AgreesWithBalls) {
  Random random(1);
  Comparison of_cameras, of_given_rays;
  for (int k = 0; k < 2000; ++k) {
    const Sizes sizes = k % 2 == 0 ? Sizes::kOrdinary : Sizes::kSmallIntegers;
    const scene::Sphere sphere = random_sphere(random, sizes);
    const ExactRay given(random_ray(random, sizes));
    compare_rays(of_given_rays, random, given);
    compare_hits(of_given_rays, random, given, sphere);
    if (k % 4 > 1) continue;
    const scene::Camera camera = random_camera(random, sizes);
    const ExactRay ray(ExactCamera(camera, random_conventions(random)),
                       random_pixel(random, camera));
    compare_rays(of_cameras, random, ray);
    compare_hits(of_cameras, random, ray, sphere);
  }
  EXPECT_GE(of_cameras.measured(), 2000);
  EXPECT_GE(of_given_rays.measured(), 2000);
}

TEST(RayError, UsesBallsBeyondDoubleDoubles) {
  // Squares overflow, and the tangent's discriminant cancels to nothing.
  const ExactRay huge(scene::Ray{{-0x1p600, 0x1p599, 0}, {1, 0, 0}});
  const scene::Sphere sphere{{0, 0, 0}, 0x1p600};
  const Intersection at = huge.intersect(sphere);
  ASSERT_EQ(at.hit_class, HitClass::kHit);
  const double s = huge.rounded_parameter(sphere, at);
  EXPECT_LE(parameter_error(huge, sphere, at, s).value, 0.5);
  EXPECT_GE(parameter_error(huge, sphere, at, nudged(s, 2)).value, 1.5);
  const ExactRay grazing(Ray{{-5, nudged(1, -1), 0}, {1, 0, 0}});
  const Intersection there = grazing.intersect(kUnit);
  ASSERT_EQ(there.hit_class, HitClass::kHit);
  EXPECT_LE(parameter_error(grazing, kUnit, there, grazing.rounded_parameter(kUnit, there)).value,
            0.5);
}

TEST(RayError, OfTheExactValueIsZero) {
  const ExactRay ray(kAlongX);
  EXPECT_EQ(parameter_error(ray, kUnit, kSmallerHit, 4).value, 0);
  EXPECT_EQ(parameter_error(ray, kUnit, kSmallerHit, nudged(4, -1)).value, 0.5);
  EXPECT_EQ(hit_point_error(ray, kUnit, kSmallerHit, {-1, 0, 0}).value, 0);
  EXPECT_EQ(sphere_residual(kUnit, {-1, 0, 0}).value().value, 0);
  EXPECT_EQ(ray_residual(ray, {-1, 0, 0}).value().value, 0);
  EXPECT_EQ(origin_error(ray, {-5, 0, 0}).value, 0);
  EXPECT_EQ(direction_error(ray, {1, 0, 0}).value, 0);
  EXPECT_FALSE(ray_residual(ray, {-5, 0, 0}).has_value());
  EXPECT_FALSE(sphere_residual({{0, 0, 0}, 0}, {1, 0, 0}).has_value());
}

TEST(RayError, OfNonFiniteValuesIsInfinite) {
  const ExactRay ray(scene::Ray{{-5, 0, 0}, {1, 0.5, 0}});
  const scene::Sphere sphere{{0, 1, 0}, 2};
  const Intersection at = ray.intersect(sphere);
  for (const double bad : {kInfinity, -kInfinity, kNaN}) {
    EXPECT_EQ(parameter_error(ray, sphere, at, bad).value, kInfinity);
    EXPECT_EQ(hit_point_error(ray, sphere, at, {0, bad, 0}).value, kInfinity);
    EXPECT_EQ(origin_error(ray, {bad, 0, 0}).value, kInfinity);
    EXPECT_EQ(direction_error(ray, {0, 0, bad}).value, kInfinity);
    EXPECT_FALSE(is_at_other_root(ray, sphere, at, bad));
  }
}

TEST(RayError, DistinguishesTheOtherRootFromAnError) {
  const ExactRay ray(kAlongX);  // roots 4 and 6: nearer to 6 than 0.5
  for (const double s : {5.6, 6.0, 6.4}) {
    EXPECT_TRUE(is_at_other_root(ray, kUnit, kSmallerHit, s));
    EXPECT_FALSE(is_at_other_root(ray, kUnit, kLargerHit, s));
  }
  for (const double s : {3.0, 4.0, 5.0, 5.4, 5.5, 6.5, 7.0}) {
    EXPECT_FALSE(is_at_other_root(ray, kUnit, kSmallerHit, s));
  }
  EXPECT_TRUE(is_at_other_root(ray, kUnit, kLargerHit, 4.4));
  EXPECT_FALSE(is_at_other_root(ray, kUnit, kTangent, 6));
}

}  // namespace
}  // namespace raycheck::reference
