// The backward error of a root, against rational arithmetic.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reference/error_measure.h"
#include "reference/exact_ray.h"
#include "tests/reference/account/changed_choice.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Ray;
using scene::Sphere;

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
    change += 2 * absolute(q) *
              (absolute(Fraction(origin)) + absolute(Fraction(centre)) + absolute(step));
  }
  if (p == 0) return 0;
  return absolute(p) / change * Fraction(0x1p53);
}

void expect_exact(const Ray& ray, const Sphere& sphere, double parameter) {
  const double got = backward_error(ray, sphere, parameter);
  const Fraction exact = exact_backward_error(ray, sphere, parameter);
  const std::string what = spelled(ray) + spelled(sphere) + " at " + scene::hexfloat(parameter);
  ASSERT_TRUE(std::isfinite(got)) << what;
  EXPECT_GE(Fraction(got), exact) << what;
  EXPECT_LE(Fraction(got), exact * Fraction(1 + kBackwardErrorWidth) +
                               Fraction(std::numeric_limits<double>::denorm_min()))
      << what;
  EXPECT_EQ(got == 0, exact == 0) << what;
}

const Ray kAlongX{{-5, 0, 0}, {1, 0, 0}};

TEST(BackwardError, IsZeroOfAnExactRoot) {
  EXPECT_EQ(backward_error(kAlongX, kUnit, 4), 0);
  EXPECT_EQ(backward_error(kAlongX, kUnit, 6), 0);
  EXPECT_EQ(backward_error({{5, 0, 0}, {1, 0, 0}}, kUnit, -4), 0);
  EXPECT_EQ(backward_error({{-5, 1, 0}, {1, 0, 0}}, kUnit, 5), 0);
  // A point sphere on the ray, at extreme distances.
  EXPECT_EQ(backward_error(kAlongX, {{3, 0, 0}, 0}, 8), 0);
  EXPECT_EQ(backward_error({{0, 0, 0}, {1, 0, 0}}, {{0x1p1000, 0, 0}, 0}, 0x1p1000), 0);
  EXPECT_EQ(backward_error({{0, 0, 0}, {0x1p-1074, 0, 0}}, {{0x1p-1074, 0, 0}, 0}, 1), 0);
}

TEST(BackwardError, IsThatOfAHandWorkedRoot) {
  // q = -1 + 2^-10: p = 2^-20 - 2^-9, over 2 (1 - 2^-10) (5 + 4 + 2^-10) + 2.
  const double e = 0x1p-10;
  const double exact = (2 * e - e * e) / (2 * (1 - e) * (9 + e) + 2) * 0x1p53;
  const double got = backward_error(kAlongX, kUnit, 4 + e);
  EXPECT_NEAR(got, exact, exact * 2 * kBackwardErrorWidth);
  // A millionth off the sphere: p = 10^-6 (2 + 10^-6) and everything in it of size 1.
  expect_exact(kAlongX, kUnit, 4 - 1e-6);
}

TEST(BackwardError, IsOfSecondOrderAtATangent) {
  // Along the tangent p is the square of how far s is off: 2^-40 / (2 (1 + 2^-20 (10 + 2^-20)) +
  // 2).
  const Ray ray{{-5, 1, 0}, {1, 0, 0}};
  const double e = 0x1p-20;
  const double got = backward_error(ray, kUnit, 5 + e);
  EXPECT_NEAR(got, e * e / (4 + 20 * e + 2 * e * e) * 0x1p53, got * 0x1p-20);
  expect_exact(ray, kUnit, 5 + e);
  expect_exact(ray, kUnit, 5 - 0x1p-50);
}

TEST(BackwardError, IsInfiniteOfWhatIsNotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(backward_error(kAlongX, kUnit, kInfinity), kInfinity);
  EXPECT_EQ(backward_error(kAlongX, kUnit, -kInfinity), kInfinity);
  EXPECT_EQ(backward_error(kAlongX, kUnit, std::numeric_limits<double>::quiet_NaN()), kInfinity);
}

TEST(BackwardError, RefusesWhatIsNoProblem) {
  EXPECT_THROW(backward_error({{0, 0, 0}, {0, 0, 0}}, kUnit, 1), std::invalid_argument);
  EXPECT_THROW(backward_error(kAlongX, {{0, 0, 0}, -1}, 1), std::invalid_argument);
}

TEST(BackwardError, IsExactOnOrdinaryCases) {
  Random random(1);
  int hits = 0;
  for (int k = 0; k < 3000; ++k) {
    const Ray ray = random_ray(random, Sizes::kOrdinary);
    const Sphere sphere = random_sphere(random, Sizes::kOrdinary);
    const ExactRay exact(ray);
    const Intersection at = exact.intersect(sphere);
    if (at.hit_class != HitClass::kHit) continue;
    ++hits;
    const double s = exact.rounded_parameter(sphere, at);
    expect_exact(ray, sphere, nudged(s, random.integer(-4, 4)));
    // A rounded s is the root of a ray whose direction was changed by as much, at most u.
    EXPECT_LE(backward_error(ray, sphere, s), 1 + 0x1p-20) << spelled(ray) << spelled(sphere);
  }
  EXPECT_GE(hits, 300);
}

TEST(BackwardError, IsExactAllOverTheDoubles) {
  Random random(2);
  int hits = 0;
  for (int k = 0; k < 3000; ++k) {
    const Ray ray = random_ray(random, Sizes::kAll);
    const Sphere sphere = random_sphere(random, Sizes::kAll);
    expect_exact(ray, sphere, any_double(random));
    const ExactRay exact(ray);
    const Intersection at = exact.intersect(sphere);
    if (at.hit_class == HitClass::kMiss) continue;
    const double s = exact.rounded_parameter(sphere, at);
    if (!std::isfinite(s)) continue;
    ++hits;
    expect_exact(ray, sphere, s);
  }
  EXPECT_GE(hits, 200);
}

TEST(BackwardError, IsAtMostAHalf) {
  EXPECT_EQ(backward_error(kAlongX, {{0, 0, 0}, 0x1p600}, 0), kMostBackwardError);
  // From the origin of the world to one coordinate of one end: q = -C.
  EXPECT_EQ(backward_error({{0, 0, 0}, {1, 0, 0}}, {{7, 0, 0}, 0}, 0), kMostBackwardError);
}

TEST(BackwardError, DoesNotDependOnTheScaleOfTheScene) {
  const Ray ray{{-5, 0.3, 0.1}, {1, 0.01, 0.02}};
  const Sphere sphere{{0.2, 0.1, -0.3}, 1};
  const double s =
      nudged(ExactRay(ray).rounded_parameter(sphere, ExactRay(ray).intersect(sphere)), 3);
  const double error = backward_error(ray, sphere, s);
  EXPECT_GT(error, 0.1);
  for (const int exponent : {-1000, 1000}) {
    const double f = std::ldexp(1.0, exponent);
    const auto& [o, d] = ray;
    const scene::Point3& c = sphere.centre;
    const Sphere scaled{{c.x * f, c.y * f, c.z * f}, sphere.radius * f};
    EXPECT_NEAR(
        backward_error({{o.x * f, o.y * f, o.z * f}, {d.x * f, d.y * f, d.z * f}}, scaled, s),
        error, error * 2 * kBackwardErrorWidth);
  }
}

}  // namespace
}  // namespace raycheck::reference
