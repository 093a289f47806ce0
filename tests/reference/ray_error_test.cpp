#include "reference/ray_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/error_measure.h"
#include "tests/numbers.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

/// Balls so narrow that what they leave open of an error does not count.
constexpr int kBits = 400;

/// Compares errors with those measured by balls alone; counts those that are neither 0 nor
/// infinite.
class Comparison {
 public:
  void expect_same(double error, double by_balls) {
    // Wider than both enclosures: 70 bits where balls of ExactRay took over.
    EXPECT_NEAR(error, by_balls, 0x1p-16 + by_balls * 0x1p-29);
    if (error > 0 && std::isfinite(error)) ++measured_;
  }
  /// The bound is no smaller than the error itself.
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

TEST(RayError, IsThatOfBalls) {
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

TEST(RayError, LeavesToBallsWhatDoubleDoublesCannotHold) {
  // Squares overflow, and the tangent's discriminant cancels to nothing.
  const ExactRay huge(scene::Ray{{-0x1p600, 0x1p599, 0}, {1, 0, 0}});
  const scene::Sphere sphere{{0, 0, 0}, 0x1p600};
  const Intersection at = huge.intersect(sphere);
  ASSERT_EQ(at.hit_class, HitClass::kHit);
  const double s = huge.rounded_parameter(sphere, at);
  EXPECT_LE(parameter_error(huge, sphere, at, s).value, 0.5);
  EXPECT_GE(parameter_error(huge, sphere, at, nudged(s, 2)).value, 1.5);
  const ExactRay grazing(scene::Ray{{-5, nudged(1, -1), 0}, {1, 0, 0}});
  const scene::Sphere unit{{0, 0, 0}, 1};
  const Intersection there = grazing.intersect(unit);
  ASSERT_EQ(there.hit_class, HitClass::kHit);
  EXPECT_LE(parameter_error(grazing, unit, there, grazing.rounded_parameter(unit, there)).value,
            0.5);
}

TEST(RayError, OfTheExactValueIsZero) {
  const ExactRay ray(scene::Ray{{-5, 0, 0}, {1, 0, 0}});
  const scene::Sphere sphere{{0, 0, 0}, 1};
  const Intersection at = ray.intersect(sphere);
  EXPECT_EQ(parameter_error(ray, sphere, at, 4).value, 0);
  EXPECT_EQ(parameter_error(ray, sphere, at, nudged(4, -1)).value, 0.5);
  EXPECT_EQ(hit_point_error(ray, sphere, at, {-1, 0, 0}).value, 0);
  EXPECT_EQ(sphere_residual(sphere, {-1, 0, 0}).value().value, 0);
  EXPECT_EQ(ray_residual(ray, {-1, 0, 0}).value().value, 0);
  EXPECT_EQ(origin_error(ray, {-5, 0, 0}).value, 0);
  EXPECT_EQ(direction_error(ray, {1, 0, 0}).value, 0);
  EXPECT_FALSE(ray_residual(ray, {-5, 0, 0}).has_value());
  EXPECT_FALSE(sphere_residual({{0, 0, 0}, 0}, {1, 0, 0}).has_value());
}

TEST(RayError, OfWhatIsNotFiniteIsInfinite) {
  const ExactRay ray(scene::Ray{{-5, 0, 0}, {1, 0.5, 0}});
  const scene::Sphere sphere{{0, 1, 0}, 2};
  const Intersection at = ray.intersect(sphere);
  for (const double bad : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(parameter_error(ray, sphere, at, bad).value, kInfinity);
    EXPECT_EQ(hit_point_error(ray, sphere, at, {0, bad, 0}).value, kInfinity);
    EXPECT_EQ(origin_error(ray, {bad, 0, 0}).value, kInfinity);
    EXPECT_EQ(direction_error(ray, {0, 0, bad}).value, kInfinity);
    EXPECT_FALSE(is_at_other_root(ray, sphere, at, bad));
  }
}

TEST(RayError, TellsTheOtherRootFromAnError) {
  const ExactRay ray(scene::Ray{{-5, 0, 0}, {1, 0, 0}});
  const scene::Sphere sphere{{0, 0, 0}, 1};  // roots 4 and 6: nearer to 6 than 0.5
  const Intersection smaller = ray.intersect(sphere);
  const Intersection larger{HitClass::kHit, WhichRoot::kLarger};
  for (const double s : {5.6, 6.0, 6.4}) {
    EXPECT_TRUE(is_at_other_root(ray, sphere, smaller, s));
    EXPECT_FALSE(is_at_other_root(ray, sphere, larger, s));
  }
  for (const double s : {3.0, 4.0, 5.0, 5.4, 5.5, 6.5, 7.0}) {
    EXPECT_FALSE(is_at_other_root(ray, sphere, smaller, s));
  }
  EXPECT_TRUE(is_at_other_root(ray, sphere, larger, 4.4));
  EXPECT_FALSE(is_at_other_root(ray, sphere, {HitClass::kTangent, WhichRoot::kSmaller}, 6));
}

}  // namespace
}  // namespace raycheck::reference
