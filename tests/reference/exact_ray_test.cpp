// Tests decisions of reference/exact_ray.h over the whole range of doubles, under small changes of
// the input, in boxes of rays and spheres, and on invalid input. Compares its correctly rounded
// values and enclosures, and those of exact_camera.h, with the literal formulas in MPFR.

#include "reference/exact_ray.h"

#include "reference/exact_camera.h"
#include "reference/interval_ray.h"
#include "tests/reference/lecture_formulas.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using namespace scene;

/// Compares the engines for one ray and two spheres.
void expect_engines_agree(const ExactRay& ray, const Sphere& first, const Sphere& second, int& hits,
                          int& pairs) {
  for (const Root root : {Root::kNearest, Root::kSmaller}) {
    const Intersection at_first = ray.intersect(first, root);
    const Intersection at_second = ray.intersect(second, root);
    ASSERT_EQ(at_first, ray.intersect(first, root, {Engine::kFieldOnly}));
    ASSERT_EQ(at_second, ray.intersect(second, root, {Engine::kFieldOnly}));
    hits += at_first.hit_class != HitClass::kMiss ? 1 : 0;
    if (at_first.hit_class == HitClass::kMiss || at_second.hit_class == HitClass::kMiss) continue;
    ++pairs;
    ASSERT_EQ(ray.compare(first, at_first, second, at_second),
              ray.compare(first, at_first, second, at_second, {Engine::kFieldOnly}));
  }
}

TEST(Engines, AgreeOnRaysAndCamerasOfAllSizes) {
  Random random(2);
  int hits = 0, pairs = 0, seen = 0, pairs_seen = 0;
  for (int k = 0; k < 1600 && !HasFailure(); ++k) {
    const Sizes sizes = random.one_in(4) ? Sizes::kSmallIntegers : Sizes::kAll;
    const Ray ray = random_ray(random, sizes);
    const Sphere first = random_sphere(random, sizes);
    const Sphere second = random_sphere(random, sizes);
    SCOPED_TRACE(spelled(ray) + spelled(first) + spelled(second));
    expect_engines_agree(ExactRay(ray), first, second, hits, pairs);
    if (k % 13 != 0) continue;
    const Camera camera = random_camera(random, sizes);
    SCOPED_TRACE(spelled(camera));
    const ExactRay through(ExactCamera(camera, random_conventions(random)),
                           random_pixel(random, camera));
    expect_engines_agree(through, first, second, seen, pairs_seen);
  }
  EXPECT_GE(hits, 200);
  EXPECT_GE(pairs, 80);
  EXPECT_GE(seen, 16);
  EXPECT_GE(pairs_seen, 4);
}

TEST(Engines, AgreeWhenUpIsParallelButForTheLastOf800Bits) {
  // E - A = (1e200 - 1e-100, 1e200, 0): at 256 bits it looks parallel to up.
  const Camera camera{{1e200, 1e200, 0}, {1e-100, 0, 0}, {1, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 3};
  const ExactCamera exact(camera, {});
  EXPECT_EQ(exact.rounded_frame().U, (scene::UnitVector3{0, 0, 1}));
  int hits = 0, pairs = 0;
  for (std::int64_t i = 0; i < 3; ++i) {
    for (std::int64_t j = 0; j < 3; ++j) {
      const ExactRay ray(exact, {i, j});
      for (const Sphere& sphere : {Sphere{{0, 0, 0}, 1}, Sphere{{0, 0, 0}, 1e200},
                                   Sphere{{0, 0, 0}, 1e201}, Sphere{{1e200, 1e200, 0}, 3}}) {
        expect_engines_agree(ray, sphere, {{1e200, 1e200, 0}, 3}, hits, pairs);
      }
    }
  }
  EXPECT_GE(hits, 9);
  EXPECT_GE(pairs, 9);
}

void expect_refused(const std::function<void()>& action, const std::string& field) {
  EXPECT_TRUE(has(thrown_by(action), field));
}

TEST(InvalidInput, IsRefusedNamingTheField) {
  expect_refused([] { ExactRay(Ray{{0, kNaN, 0}, {1, 0, 0}}); }, "ray.origin");
  expect_refused([] { ExactRay(Ray{{0, 0, 0}, {0, 0, 0}}); }, "ray.direction");
  Camera camera{{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 2};
  const ExactCamera exact(camera, {});
  EXPECT_NO_THROW(ExactRay(exact, {2, 1}));
  for (const scene::Pixel& pixel : {scene::Pixel{3, 0}, {0, 2}, {-1, 0}, {0, -1}}) {
    expect_refused([&] { ExactRay(exact, pixel); }, "pixel");
  }
  camera.up = {0, 0, 1e-300};
  expect_refused([&] { ExactCamera(camera, {}); }, "camera.up");
  camera.width = 1;
  expect_refused([&] { ExactCamera(camera, {}); }, "camera.width");
}

TEST(InvalidInput, OfASphereIsRefusedByEveryFunctionThatTakesOne) {
  const Camera camera{{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 3};
  const Sphere good{{0, 0, 0}, 2};
  for (const Sphere& bad : {Sphere{{0, 0, 0}, -1}, Sphere{{0, 0, 0}, kNaN}}) {
    for (const ExactRay& ray :
         {ExactRay(Ray{{-5, 0, 0}, {1, 0, 0}}), ExactRay(ExactCamera(camera, {}), {1, 1})}) {
      const auto refuses = [&](auto call) { expect_refused(call, "sphere.radius"); };
      refuses([&] { ray.intersect(bad); });
      refuses([&] { ray.compare(bad, kSmallerHit, good, kSmallerHit); });
      refuses([&] { ray.compare(good, kSmallerHit, bad, kSmallerHit); });
      refuses([&] { ray.nearest(std::vector<Sphere>{good, bad}, {}); });
      refuses([&] { ray.parameter(bad, kSmallerHit); });
      refuses([&] { ray.point(bad, kSmallerHit); });
      refuses([&] { ray.rounded_parameter(bad, kSmallerHit); });
      refuses([&] { ray.rounded_point(bad, kSmallerHit); });
      refuses([&] { ray.enclose(128).half_chord_sq(bad); });
    }
  }
}

const Ray kFromZero{{0, 0, 0}, {1, 0, 0}};

TEST(IntervalRay, TouchesAtItsOriginByTheSmallerRoot) {
  const Ray along{{1, 0, 0}, {0, 1, 0}};
  for (const Root root : {Root::kNearest, Root::kSmaller}) {
    const auto found = intersect_by_intervals(along, {{0, 0, 0}, 1}, root);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->intersection, (Intersection{HitClass::kTangent, WhichRoot::kSmaller}));
  }
}

TEST(Nearest, IsEmptyIfNothingIsMet) {
  const ExactRay ray(kFromZero);
  EXPECT_FALSE(ray.nearest({}, {}).has_value());
  const std::vector<Sphere> spheres{{{-5, 0, 0}, 1}, {{5, 5, 0}, 1}};
  EXPECT_FALSE(ray.nearest(spheres, {}).has_value());
}

TEST(Nearest, ReportsEveryTieAndTheFirstOfThem) {
  // All except the first two are met at s = 4, the fifth from inside.
  const std::vector<Sphere> spheres{{{9, 0, 0}, 1}, {{-3, 0, 0}, 1}, {{6, 0, 0}, 2}, {{5, 0, 0}, 1},
                                    {{0, 0, 0}, 4}, {{4, 3, 0}, 3},  {{8, 0, 0}, 4}};
  const auto nearest = ExactRay(kFromZero).nearest(spheres, {});
  ASSERT_TRUE(nearest.has_value());
  EXPECT_EQ(nearest->index, 2u);
  EXPECT_EQ(nearest->intersection, kSmallerHit);
  EXPECT_EQ(nearest->ties, (std::vector<std::size_t>{2, 3, 4, 5, 6}));
}

TEST(Nearest, EqualSpheresTieWithoutTheField) {
  const ExactRay ray(Ray{{0, 0, 0}, {1, 0.1, 0.2}});
  const Sphere sphere = {{5, 0.3, 1}, 1};
  const Intersection at = ray.intersect(sphere);
  ASSERT_EQ(at, kSmallerHit);
  FilterStage highest = FilterStage::kIntervals;
  EXPECT_EQ(ray.compare(sphere, at, sphere, at, {Engine::kFiltered, &highest}), 0);
  EXPECT_EQ(highest, FilterStage::kIntervals);
  EXPECT_EQ(ray.compare(sphere, at, sphere, at, {Engine::kFieldOnly}), 0);
  EXPECT_EQ(ray.compare(sphere, at, sphere, {HitClass::kHit, WhichRoot::kLarger}), -1);
}

TEST(Nearest, FollowsTheConventions) {
  const std::vector<Sphere> spheres{{{0, 0, 0}, 3}, {{4, 2, 0}, 2}, {{9, 0, 0}, 1}};
  const ExactRay ray(kFromZero);
  Conventions conventions;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 0u);
  conventions.root = Root::kSmaller;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 1u);
  conventions.tangent = scene::Tangent::kEither;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 1u);
  conventions.tangent = scene::Tangent::kMiss;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 2u);
}

constexpr double kBoxChange = 0x1p-20;

struct BoxCounts {
  int hits = 0, misses = 0, open = 0, contradicted = 0;
};

/// Counts for boxes of spheres that the ray nearly grazes, and for rays and spheres in these boxes
/// whose numbers are changed by up to `change`.
BoxCounts box_counts(double change) {
  Random random(11);
  BoxCounts all;
  for (int k = 0; k < 3000; ++k) {
    const Root root = random.one_in(2) ? Root::kNearest : Root::kSmaller;
    const double along = random.between(-4, 9);
    const Ray ray = {{0.5, 0.25, -2}, {0, 0, random.power_of_ten(-2, 2)}};
    const double across = random.power_of_ten(-1, 1);
    const Sphere least = {{0.5 + across, 0.25, along},
                          across * (1 + random.between(-8, 8) * kBoxChange)};
    Sphere greatest = least;
    greatest.radius *= 1 + random.between(0, 4) * kBoxChange;
    const auto common = intersection_in({ray, ray}, {least, greatest}, kBoxChange, root);
    if (!common) {
      ++all.open;
      continue;
    }
    (common->hit_class == HitClass::kMiss ? all.misses : all.hits) += 1;
    bool contradicted = false;
    for (int sample = 0; sample < 12; ++sample) {
      Ray one = ray;
      Sphere sphere = least;
      sphere.radius = sample % 2 == 0 ? least.radius : greatest.radius;
      for (double* x : {&one.origin.x, &one.origin.y, &one.origin.z, &one.direction.z,
                        &sphere.centre.x, &sphere.centre.y, &sphere.centre.z, &sphere.radius}) {
        *x *= 1 + random.sign() * change;
      }
      contradicted |= ExactRay(one).intersect(sphere, root) != *common;
    }
    all.contradicted += contradicted ? 1 : 0;
  }
  return all;
}

TEST(IntersectionInBoxes, HoldsInThemAndCloseBy) {
  const BoxCounts within = box_counts(kBoxChange * (1 - 0x1p-30));
  EXPECT_EQ(within.contradicted, 0);
  EXPECT_GT(within.hits, 200);
  EXPECT_GT(within.misses, 200);
  EXPECT_GT(within.open, 200);
}

TEST(IntersectionInBoxes, DoesNotHoldFartherOff) {
  EXPECT_GT(box_counts(4 * kBoxChange).contradicted, 20);
}

TEST(IntersectionInBoxes, IsExactForASingleRayThatPassesClearly) {
  Random random(5);
  int decided = 0;
  for (int k = 0; k < 2000; ++k) {
    const Ray ray = random_ray(random, Sizes::kOrdinary);
    const Sphere sphere = random_sphere(random, Sizes::kOrdinary);
    const auto found = intersection_in({ray, ray}, {sphere, sphere}, 0, Root::kNearest);
    if (!found) continue;
    ++decided;
    EXPECT_EQ(*found, ExactRay(ray).intersect(sphere));
  }
  EXPECT_GT(decided, 1900);
}

TEST(IntersectionInBoxes, RefusesInvalidInput) {
  const Ray ray = {{0, 0, 0}, {0, 0, 1}};
  const Ray none = {{0, 0, 0}, {0, 0, 0}};
  EXPECT_THROW(intersection_in({none, ray}, {kUnit, kUnit}, 0, {}), std::invalid_argument);
  EXPECT_THROW(intersection_in({ray, none}, {kUnit, kUnit}, 0, {}), std::invalid_argument);
  EXPECT_THROW(intersection_in({ray, ray}, {{{}, -1}, kUnit}, 0, {}), std::invalid_argument);
}

constexpr auto kSingle = scene::Precision::kSingle;

/// The number of compared values, and of values at the ends of the range of doubles.
struct RoundedCounts {
  int values = 0, hits = 0, subnormal = 0, overflowed = 0, zero = 0;

  void count(double value) {
    ++values;
    if (value == 0) {
      ++zero;
    } else if (std::isinf(value)) {
      ++overflowed;
    } else if (std::abs(value) < kSmallestNormal) {
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
  // The roots from inside are s = 2^53 + 1 and 2^53 + 3, halfway between doubles.
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
