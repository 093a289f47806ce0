// Correctly rounded values and enclosures of reference/exact_ray.h and exact_camera.h, against the
// literal formulas in MPFR.

#include <gtest/gtest.h>

#include <limits>

#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "tests/reference/lecture_formulas.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

constexpr auto kSingle = scene::Precision::kSingle;

/// How many values were compared, and how many of them lie at the ends of the double range.
struct RoundedCounts {
  int values = 0;
  int hits = 0;
  int subnormal = 0;
  int overflowed = 0;
  int zero = 0;

  void count(double value) {
    ++values;
    if (value == 0) {
      ++zero;
    } else if (std::isinf(value)) {
      ++overflowed;
    } else if (std::abs(value) < std::numeric_limits<double>::min()) {
      ++subnormal;
    }
  }
  template <class Triple>
  void count(const Triple& value) {
    count(value.x);
    count(value.y);
    count(value.z);
  }
};

template <class Value, class Narrow, class Truth>
void expect_value(const Value& rounded, const Narrow& enclosure, const Truth& truth,
                  RoundedCounts& counts) {
  EXPECT_TRUE(is_nearest(rounded, truth));
  EXPECT_TRUE(contains(enclosure, truth));
  counts.count(rounded);
}

void expect_hit(const ExactRay& ray, const Big3& L, const Big3& D, const Big& unit,
                const scene::Sphere& sphere, RoundedCounts& counts) {
  const Intersection at = ray.intersect(sphere);
  const LectureHit truth = lecture_hit(L, D, sphere);
  if (at.hit_class == HitClass::kMiss) {
    EXPECT_TRUE(truth.d_sq < 0 || truth.larger() < 0);
    return;
  }
  if (at.hit_class == HitClass::kTangent || truth.d_sq < 0) return;
  ++counts.hits;
  const Big s = at.root == WhichRoot::kSmaller ? truth.smaller() : truth.larger();
  expect_value(ray.rounded_parameter(sphere, at), ray.parameter(sphere, at), Big(s / unit), counts);
  expect_value(ray.rounded_point(sphere, at), ray.point(sphere, at), L + s * D, counts);
}

void expect_camera_is_rounded(Random& random, Sizes sizes, RoundedCounts& counts) {
  const scene::Camera camera = random_camera(random, sizes);
  const scene::Conventions conventions = random_conventions(random);
  const scene::Pixel pixel = random_pixel(random, camera);
  SCOPED_TRACE(spelled(camera) + " pixel " + std::to_string(pixel.i) + " " +
               std::to_string(pixel.j));
  const ExactCamera exact(camera, conventions);
  const LectureRay truth = lecture_ray(camera, conventions, pixel);
  const RoundedFrame rounded = exact.rounded_frame();
  const EnclosedFrame enclosed = exact.frame();
  expect_value(rounded.U, enclosed.U, truth.U, counts);
  expect_value(rounded.V, enclosed.V, truth.V, counts);
  expect_value(rounded.W, enclosed.W, truth.W, counts);

  const ExactRay ray(exact, pixel);
  expect_value(ray.rounded_pixel_point(), ray.pixel_point(), truth.P, counts);
  expect_value(ray.rounded_direction(), ray.direction(), truth.D, counts);
  const bool focal = conventions.origin == scene::Origin::kFocal;
  const Big3 L = focal ? big(camera.eye) : truth.P;
  expect_value(ray.rounded_origin(), ray.origin(), L, counts);
  EXPECT_TRUE(contains(ray.enclose(256).length(), truth.length));
  for (int k = 0; k < 3; ++k) {
    const scene::Sphere sphere = random_sphere(random, sizes);
    SCOPED_TRACE(spelled(sphere));
    expect_hit(ray, L, truth.D, 1, sphere, counts);
  }
}

void expect_given_ray_is_rounded(Random& random, Sizes sizes, RoundedCounts& counts) {
  const scene::Ray given = random_ray(random, sizes);
  const scene::Sphere sphere = random_sphere(random, sizes);
  SCOPED_TRACE(spelled(given) + spelled(sphere));
  const ExactRay ray(given);
  const Big3 direction = big(given.direction);
  const Big length = norm(direction);
  const Big3 D = direction / length;
  expect_value(ray.rounded_direction(), ray.direction(), D, counts);
  expect_hit(ray, big(given.origin), D, length, sphere, counts);
}

template <class Expect>
RoundedCounts repeated(int times, std::uint64_t seed, Sizes sizes, Expect expect) {
  Random random(seed);
  RoundedCounts counts;
  for (int k = 0; k < times && !testing::Test::HasFailure(); ++k) expect(random, sizes, counts);
  return counts;
}

TEST(CameraValues, OfEverySizeAreCorrectlyRounded) {
  const RoundedCounts ordinary = repeated(160, 1, Sizes::kOrdinary, expect_camera_is_rounded);
  const RoundedCounts whole = repeated(160, 2, Sizes::kSmallIntegers, expect_camera_is_rounded);
  const RoundedCounts all = repeated(160, 3, Sizes::kAll, expect_camera_is_rounded);
  for (const RoundedCounts& counts : {ordinary, whole, all}) {
    EXPECT_GE(counts.values, 2800);
    EXPECT_GE(counts.hits, 20);
  }
  EXPECT_GE(whole.zero, 40);
  EXPECT_GE(all.subnormal, 4);
  EXPECT_GE(all.overflowed, 1);
}

TEST(RayValues, OfEverySizeAreCorrectlyRounded) {
  const RoundedCounts ordinary = repeated(2000, 4, Sizes::kOrdinary, expect_given_ray_is_rounded);
  const RoundedCounts whole = repeated(2000, 5, Sizes::kSmallIntegers, expect_given_ray_is_rounded);
  const RoundedCounts all = repeated(2000, 6, Sizes::kAll, expect_given_ray_is_rounded);
  for (const RoundedCounts& counts : {ordinary, whole, all}) EXPECT_GE(counts.hits, 300);
  EXPECT_GE(all.subnormal, 30);
  EXPECT_GE(all.overflowed, 25);
}

TEST(RayValues, ExactMidpointsGoToTheEvenDouble) {
  // From inside a point-symmetric set-up s = 2^53 + 1 and 2^53 + 3, halfway between doubles.
  const double base = 0x1p53;
  for (const double odd : {1.0, 3.0}) {
    const ExactRay ray(scene::Ray{{-base, 0, 0}, {1, 0, 0}});
    const scene::Sphere sphere{{odd + 1, 0, 0}, 1};
    const Intersection at = ray.intersect(sphere);
    EXPECT_EQ(ray.rounded_parameter(sphere, at), odd == 1 ? base : base + 4);
  }
}

TEST(RayValues, EnclosuresAreAsNarrowAsAsked) {
  Random random(8);
  for (int k = 0; k < 100; ++k) {
    const scene::Camera camera = random_camera(random, Sizes::kAll);
    const ExactCamera exact(camera, {});
    const ExactRay ray(exact, random_pixel(random, camera));
    for (const int bits : {70, 300}) {
      EXPECT_TRUE(exact.frame(bits).V.x.is_within(bits));
      EXPECT_TRUE(ray.pixel_point(bits).y.is_within(bits));
      EXPECT_TRUE(ray.direction(bits).z.is_within(bits));
    }
  }
}

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
