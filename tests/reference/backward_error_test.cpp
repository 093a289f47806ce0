// The backward error of a root, against rational arithmetic.

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reference/error_measure.h"
#include "reference/exact_ray.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Ray;
using scene::Sphere;
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
  EXPECT_LE(Fraction(got), exact * Fraction(1 + kBackwardErrorWidth) +
                               Fraction(std::numeric_limits<double>::denorm_min()))
      << what;
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

TEST(BackwardError, IsInfiniteOfWhatIsNotFinite) {
  EXPECT_EQ(backward_error(kAlongX, kUnit, kInfinity).value, kInfinity);
  EXPECT_EQ(backward_error(kAlongX, kUnit, -kInfinity).value, kInfinity);
  EXPECT_EQ(backward_error(kAlongX, kUnit, kNaN).value, kInfinity);
}

TEST(BackwardError, RefusesWhatIsNoProblem) {
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

}  // namespace
}  // namespace raycheck::reference
