// Floats: values rounded to them once, and errors in their ulps.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/error_measure.h"
#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "reference/ray_error.h"

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

TEST(RoundedToFloat, IsEveryValueOfACamera) {
  const scene::Camera camera{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 7, 5};
  const ExactCamera exact(camera, {});
  const RoundedFrame doubles = exact.rounded_frame(), floats = exact.rounded_frame(kSingle);
  EXPECT_EQ(floats.U.x, static_cast<float>(doubles.U.x));
  EXPECT_NE(floats.U.x, doubles.U.x);
  const ExactRay ray(exact, {2, 3});
  EXPECT_EQ(ray.rounded_direction(kSingle).z, static_cast<float>(ray.rounded_direction().z));
  EXPECT_EQ(ray.rounded_pixel_point(kSingle).y, static_cast<float>(ray.rounded_pixel_point().y));
  EXPECT_EQ(ray.rounded_origin(kSingle).x, static_cast<float>(ray.rounded_origin().x));
}

/// The error of `given` as s of a point at distance `exact`.
double error(double given, double exact) {
  const ExactRay ray(scene::Ray{{0, 0, 0}, {1, 0, 0}});
  const scene::Sphere point{{exact, 0, 0}, 0};
  const double by_ray = parameter_error(ray, point, ray.intersect(point), given, kSingle);
  EXPECT_EQ(by_ray, ulp_error(given, Enclosure(exact, 192), kSingle));
  return by_ray;
}

TEST(UlpOfFloat, IsTheGapAroundTheTruth) {
  EXPECT_EQ(error(1 + 0x1p-23, 1), 1);
  EXPECT_EQ(error(1 - 0x1p-24, 1), 0.5);
  EXPECT_EQ(error(1, 1 - 0x1p-24), 1);
  EXPECT_EQ(error(3, 3 + 0x1p-24), 0.25);
  EXPECT_EQ(error(0x1p100, 0x1p100 + 0x1p80), 0x1p3);
}

TEST(UlpOfFloat, OfSubnormalsIsTheLeastFloat) {
  EXPECT_EQ(error(0, 0x1p-140), 0x1p9);
  EXPECT_EQ(error(0x1p-149, 0x1p-151), 0.75);
  EXPECT_EQ(error(0x1p-126, 0x1p-126 - 0x1p-149), 1);
  EXPECT_EQ(error(0x1p-126, 0x1p-126 + 0x1p-149), 1);
  EXPECT_EQ(error(0x1p-125, 0x1p-125 + 0x1p-148), 1);
  EXPECT_EQ(error(0x1p-125, 0x1p-125 - 0x1p-149), 1);
}

}  // namespace
}  // namespace raycheck::reference
