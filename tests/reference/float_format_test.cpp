// Values rounded to floats, once.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/exact_ray.h"

namespace raycheck::reference {
namespace {

constexpr auto kSingle = scene::Precision::kSingle;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// s of the ray along x from 0 at a sphere around (centre, 0, 0).
double rounded_s(double centre, double radius, scene::Precision precision) {
  const ExactRay ray(scene::Ray{{0, 0, 0}, {1, 0, 0}});
  const scene::Sphere sphere{{centre, 0, 0}, radius};
  return ray.rounded_parameter(sphere, ray.intersect(sphere), precision);
}

TEST(RoundedToFloat, IsRoundedOnce) {
  // 2 - r lies at, just above and just below the midpoint of 1 and the next float; the double
  // nearest to all three is that midpoint.
  const double at = 1 - 0x1p-24;
  for (const double r : {at, at - 0x1p-53, at + 0x1p-53}) {
    EXPECT_EQ(rounded_s(2, r, scene::Precision::kDouble), 1 + 0x1p-24);
  }
  EXPECT_EQ(rounded_s(2, at, kSingle), 1);
  EXPECT_EQ(rounded_s(2, at - 0x1p-53, kSingle), 1 + 0x1p-23);
  EXPECT_EQ(rounded_s(2, at + 0x1p-53, kSingle), 1);
}

TEST(RoundedToFloat, OverflowsAndUnderflowsAsFloatsDo) {
  const double beyond = 0x1p128 - 0x1p103;
  EXPECT_EQ(rounded_s(beyond, 0, kSingle), kInfinity);
  EXPECT_EQ(rounded_s(std::nextafter(beyond, 0), 0, kSingle), 0x1p128 - 0x1p104);
  EXPECT_EQ(rounded_s(0x1p-150, 0, kSingle), 0);
  EXPECT_EQ(rounded_s(std::nextafter(0x1p-150, 1), 0, kSingle), 0x1p-149);
  EXPECT_EQ(rounded_s(0x1.8p-148, 0, kSingle), 0x1.8p-148);
  EXPECT_EQ(rounded_s(0x1.4p-148, 0, kSingle), 0x1p-148);
}

TEST(RoundedToFloat, HasNoNegativeZero) {
  const ExactRay ray(scene::Ray{{0, 0, 0}, {1, -0x1p-160, 0}});
  const scene::Sphere sphere{{4, 0, 0}, 1};
  const scene::Point3 Q = ray.rounded_point(sphere, ray.intersect(sphere), kSingle);
  EXPECT_EQ(Q.x, 3);
  EXPECT_EQ(Q.y, 0);
  EXPECT_FALSE(std::signbit(Q.y));
}

}  // namespace
}  // namespace raycheck::reference
