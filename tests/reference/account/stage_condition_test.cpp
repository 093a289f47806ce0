// Condition numbers of single steps, against their derivatives by hand.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "reference/account/condition.h"
#include "tests/reference/account/condition_cases.h"
#include "tests/reference/lecture_formulas.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Sphere;

Big sum_of_sizes(const Big3& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

void expect_ray_stages(const RayStageConditions& got, const LectureRay& ray, const Big3& E,
                       const Big& n, const Big& alpha, const Big& beta, const std::string& what) {
  const Big point = sum_of_sizes(E) + abs(n) + abs(alpha) + abs(beta) +
                    abs(n) * sum_of_sizes(ray.W) + abs(alpha) * sum_of_sizes(ray.U) +
                    abs(beta) * sum_of_sizes(ray.V);
  ASSERT_TRUE(got.pixel_point.has_value());
  if (norm(ray.P) != 0) expect_condition(*got.pixel_point, point / norm(ray.P), "P of " + what);
  // dD/dP_k = (e_k - D_k D)/l, of size sqrt(1 - D_k^2)/l.
  Big direction = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Big D_k = coordinates_of(ray.D)[k];
    const Big rest = 1 - D_k * D_k;
    if (rest <= 0) continue;
    direction +=
        sqrt(rest) / ray.length * (abs(coordinates_of(ray.P)[k]) + abs(coordinates_of(E)[k]));
  }
  expect_condition(got.direction, direction, "D of " + what);
}

void expect_sphere_stages(const SphereStageConditions& got, const Big3& L, const Big3& D,
                          const Sphere& sphere, const Intersection& at, const std::string& what) {
  const LectureHit hit = lecture_hit(L, D, sphere);
  const Big3 T = big(sphere.centre) - L;
  Big axial = 0;
  Big half = 2 * Big(sphere.radius) * sphere.radius;
  for (std::size_t k = 0; k < 3; ++k) {
    const Big T_k = coordinates_of(T)[k];
    const Big D_k = coordinates_of(D)[k];
    const Big across = abs(T_k - hit.v * D_k);
    axial += abs(D_k * T_k) + across * abs(D_k);
    half += 2 * across * (abs(T_k) + abs(hit.v * D_k));
  }
  if (hit.v != 0) expect_condition(got.axial_distance, axial / abs(hit.v), "v of " + what);
  if (hit.d_sq != 0) expect_condition(got.half_chord_sq, half / abs(hit.d_sq), "d^2 of " + what);
  ASSERT_EQ(got.root.has_value(), at.hit_class != HitClass::kMiss);
  ASSERT_EQ(got.point.has_value(), at.hit_class != HitClass::kMiss);
  if (at.hit_class != HitClass::kHit) return;
  const Big s = at.root == WhichRoot::kSmaller ? hit.smaller() : hit.larger();
  const Big root_sum = abs(hit.v) + sqrt(hit.d_sq) / 2;
  // Where the ray starts on the sphere the literal formula is 0 but for rounding.
  if (abs(s) > root_sum * power_of_two(-3000)) {
    expect_condition(*got.root, root_sum / abs(s), "s of " + what);
  } else {
    EXPECT_EQ(*got.root, kUnbounded) << what;
  }
  const Big point = sum_of_sizes(L) + abs(s) + abs(s) * sum_of_sizes(D);
  expect_condition(*got.point, point / norm(L + s * D), "Q of " + what);
}

TEST(StageCondition, IsThatOfTheStepsByHand) {
  Random random(1);
  int hits = 0;
  for (const Sizes sizes : {Sizes::kSmallIntegers, Sizes::kOrdinary}) {
    for (int k = 0; k < 150; ++k) {
      scene::Camera camera = random_camera(random, sizes);
      const scene::Conventions conventions = random_conventions(random);
      const scene::Pixel pixel = random_pixel(random, camera);
      const Sphere sphere = random_sphere(random, sizes);
      const ExactCamera exact_camera(camera, conventions);
      const ExactRay exact(exact_camera, pixel);
      const LectureRay ray = lecture_ray(camera, conventions, pixel);
      const bool top_first = conventions.rows == scene::Rows::kTopFirst;
      const Big alpha =
          lecture_coordinate(camera.left, camera.right, pixel.i, camera.width, conventions.samples);
      const Big beta = lecture_coordinate(camera.bottom, camera.top,
                                          top_first ? camera.height - 1 - pixel.j : pixel.j,
                                          camera.height, conventions.samples);
      const std::string what = spelled(camera) + spelled(sphere);
      // A P that is 0 but for rounding says nothing.
      if (norm(ray.P) < power_of_two(-3000)) continue;
      expect_ray_stages(stage_conditions(exact), ray, big(camera.eye), Big(camera.near), alpha,
                        beta, what);
      const Big3 L = conventions.origin == scene::Origin::kPixel ? ray.P : big(camera.eye);
      const Intersection at = exact.intersect(sphere);
      expect_sphere_stages(stage_conditions(exact, sphere, at), L, ray.D, sphere, at, what);
      if (at.hit_class == HitClass::kHit) ++hits;
      const scene::Ray given = random_ray(random, sizes);
      const ExactRay of_given(given);
      EXPECT_FALSE(stage_conditions(of_given).pixel_point.has_value());
      const Intersection there = of_given.intersect(sphere);
      const Big3 d = big(given.direction);
      expect_sphere_stages(stage_conditions(of_given, sphere, there), big(given.origin),
                           d / norm(d), sphere, there, spelled(given) + spelled(sphere));
      if (there.hit_class == HitClass::kHit) ++hits;
    }
  }
  EXPECT_GE(hits, 40);
}

TEST(StageCondition, OfATangentsRootIsThatOfV) {
  const ExactRay ray(scene::Ray{{-5, 1, 0}, {1, 0, 0}});
  const Sphere sphere{{0, 0, 0}, 1};
  const Intersection at = ray.intersect(sphere);
  ASSERT_EQ(at.hit_class, HitClass::kTangent);
  const SphereStageConditions got = stage_conditions(ray, sphere, at);
  expect_condition(got.root.value(), Big(1), "s");
  EXPECT_EQ(got.half_chord_sq, kUnbounded);
  // (|L| + s + s |D|)/|Q|, Q = (0, 1, 0).
  expect_condition(got.point.value(), Big(6 + 5 + 5), "Q");
}

}  // namespace
}  // namespace raycheck::reference
