// Condition numbers of given rays, against closed forms of their derivatives.

#include <gtest/gtest.h>

#include <cmath>

#include "reference/account/condition.h"
#include "tests/reference/account/condition_cases.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Ray;
using scene::Sphere;

Big3 axis(int k) { return {Big(k == 0 ? 1 : 0), Big(k == 1 ? 1 : 0), Big(k == 2 ? 1 : 0)}; }

/// sum |dq/dx| |x| over |q|; infinite as condition numbers are.
Big over(const Big& sum, const Big& size) {
  if (size != 0) return sum / size;
  return sum == 0 ? Big(0) : Big(kUnbounded);
}

/// The values of a ray and a sphere, and their derivatives by hand.
struct ByHand {
  ByHand(const Ray& ray, const Sphere& sphere, const Intersection& at)
      : L(big(ray.origin)), d(big(ray.direction)), C(big(sphere.centre)), r(sphere.radius) {
    const Big3 t = C - L;
    const Big length = norm(d);
    const Big3 D = d / length;
    v = dot(t, D);
    const Big3 moment = cross(t, D);
    half_chord_sq = r * r - dot(moment, moment);
    const Big half_chord = half_chord_sq > 0 ? Big(sqrt(half_chord_sq)) : Big(0);
    s = (at.root == WhichRoot::kSmaller ? Big(v - half_chord) : Big(v + half_chord)) / length;
    // 0 exactly where the ray starts on the sphere.
    if (dot(t, t) == r * r && (at.root == WhichRoot::kSmaller) == (dot(t, d) > 0)) s = 0;
    q = L + s * d - C;
    for (int k = 0; k < 3; ++k) {
      const auto K = static_cast<std::size_t>(k);
      const Big size_of_ends = abs(coordinates_of(L)[K]) + abs(coordinates_of(C)[K]);
      const Big size_of_d = abs(coordinates_of(d)[K]);
      const Big T_k = coordinates_of(t)[K];
      const Big D_k = coordinates_of(D)[K];
      const Big by_d = abs(T_k - v * D_k) / length;
      axial_sum += abs(D_k) * size_of_ends + by_d * size_of_d;
      half_sum += 2 * (abs(T_k - v * D_k) * size_of_ends + abs(v) * by_d * size_of_d);
    }
    half_sum += 2 * r * r;
  }

  /// From p(s) = |L + s d - C|^2 - r^2 = 0: ds/dx = -(dp/dx) / (dp/ds).
  Big parameter_condition() const {
    Big sum = 2 * r * r;
    for (std::size_t k = 0; k < 3; ++k) {
      const Big size =
          abs(coordinates_of(L)[k]) + abs(coordinates_of(C)[k]) + abs(s * coordinates_of(d)[k]);
      sum += 2 * abs(coordinates_of(q)[k]) * size;
    }
    return over(sum / abs(2 * dot(q, d)), abs(s));
  }

  /// dQ/dx = dL/dx + s dd/dx + d ds/dx.
  Big point_condition() const {
    const Big slope = 2 * dot(q, d);
    Big sum = norm((2 * r * r / slope) * d);
    for (int k = 0; k < 3; ++k) {
      const auto K = static_cast<std::size_t>(k);
      const Big by_start = -2 * coordinates_of(q)[K] / slope;
      sum += norm(axis(k) + by_start * d) * abs(coordinates_of(L)[K]);
      sum += norm(by_start * d) * abs(coordinates_of(C)[K]);
      sum += norm(s * axis(k) + (s * by_start) * d) * abs(coordinates_of(d)[K]);
    }
    return over(sum, norm(q + C));
  }

  Big3 L, d, C;
  Big r, v, half_chord_sq, s;
  Big3 q;
  Big axial_sum, half_sum;
};

int compare_with_closed_forms(Sizes sizes, std::uint64_t seed, int cases) {
  Random random(seed);
  int compared = 0;
  for (int k = 0; k < cases; ++k) {
    const Ray ray = random_ray(random, sizes);
    const Sphere sphere = random_sphere(random, sizes);
    const ExactRay exact(ray);
    const Intersection at = exact.intersect(sphere);
    if (at.hit_class == HitClass::kTangent) continue;
    const ByHand by_hand(ray, sphere, at);
    const std::string what = spelled(ray) + spelled(sphere);
    // A v or d^2 that is 0 only up to the rounding of the closed form says nothing.
    if (abs(by_hand.v) > by_hand.axial_sum * power_of_two(-5000)) {
      expect_condition(condition_of_axial_distance(exact, sphere),
                       by_hand.axial_sum / abs(by_hand.v), "v of " + what);
    }
    if (abs(by_hand.half_chord_sq) > by_hand.half_sum * power_of_two(-5000)) {
      expect_condition(condition_of_half_chord_sq(exact, sphere),
                       by_hand.half_sum / abs(by_hand.half_chord_sq), "d^2 of " + what);
    }
    if (at.hit_class != HitClass::kHit) continue;
    expect_condition(condition_of_parameter(exact, sphere, at), by_hand.parameter_condition(),
                     "s of " + what);
    expect_condition(condition_of_point(exact, sphere, at), by_hand.point_condition(),
                     "Q of " + what);
    ++compared;
  }
  return compared;
}

TEST(Condition, IsThatOfTheClosedForms) {
  EXPECT_GE(compare_with_closed_forms(Sizes::kOrdinary, 1, 2000), 200);
}
TEST(Condition, IsThatOfTheClosedFormsOfSmallIntegers) {
  EXPECT_GE(compare_with_closed_forms(Sizes::kSmallIntegers, 2, 2000), 200);
}
TEST(Condition, IsThatOfTheClosedFormsAllOverTheDoubles) {
  EXPECT_GE(compare_with_closed_forms(Sizes::kAll, 3, 1000), 100);
}

TEST(Condition, GrowsLikeOneOverTheRootOfTheDistanceToATangent) {
  // With y = 1 - e and q = sqrt(1 - y^2): (1/q + y^2/q + 5 + s)/s, s = 5 - q.
  for (const double e : {0x1p-10, 0x1p-20, 0x1p-30, 0x1p-40, 0x1p-53}) {
    const double y = 1 - e;
    const Big q = sqrt(1 - Big(y) * y);
    const ExactRay ray(Ray{{-5, y, 0}, {1, 0, 0}});
    expect_condition(condition_of_parameter(ray, kUnit, kSmallerHit),
                     (1 / q + Big(y) * y / q + 10 - q) / (5 - q), "s near a tangent");
  }
}

TEST(Condition, OfTheParameterIsInfiniteOnTheSurface) {
  const ExactRay ray(Ray{{-1, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(condition_of_parameter(ray, {{0, 0, 0}, 1}, kSmallerHit), kUnbounded);
  expect_condition(condition_of_parameter(ray, {{0, 0, 0}, 1}, kLargerHit), Big(2), "s");
}

}  // namespace
}  // namespace raycheck::reference
