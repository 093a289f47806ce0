// Compares what the reference computes first, in doubles (reference/internal/quick_line.h) and in
// double-doubles (reference/near_error.h), with balls. Too small bounds, the mutants, are exceeded.

#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/internal/quick_line.h"
#include "reference/internal/ray_impl.h"
#include "reference/near_error.h"
#include "reference/ray_error.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using namespace scene;

constexpr Coefficient kCoefficients[] = {Coefficient::kDiscriminant, Coefficient::kConstant,
                                         Coefficient::kLinear};

/// A sphere that the line L + s D almost touches, from outside or inside.
Sphere nearly_touched(Random& random, const Point3& L, const Vector3& D) {
  const double s = random.between(-3, 3), r = std::ldexp(1.0, int(random.integer(-30, 30)));
  const double side = r * (1 + random.sign() * std::ldexp(1.0, -int(random.integer(1, 52))));
  const double length = std::hypot(D.x, D.y) + 0x1p-300;
  return {{L.x + s * D.x - side * D.y / length, L.y + s * D.y + side * D.x / length, L.z + s * D.z},
          r};
}

/// The largest error of a coefficient over its bound; `decided` counts certain signs.
double largest_share(const ExactRay& ray, const QuickLine& line, const Sphere& sphere,
                     int& decided) {
  const ExactRay::Source& source = ray.source();
  const bool starts_at_g = source.camera && source.camera->conventions.origin == Origin::kPixel;
  const QuickPair quick(line, starts_at_g, base_of(source), sphere);
  if (!quick.is_in_range()) return 0;
  const EnclosureLift lift{2048};
  const auto exact_line = line_of(lift, source);
  const auto exact = line_and_sphere(exact_line, lift_sphere(lift, sphere));
  double largest = 0;
  for (const Coefficient of : kCoefficients) {
    const auto [value, doubt] = quick.value(of);
    const Enclosure off = abs(Enclosure(value, 2048) - coefficient_of(of, exact));
    largest = std::max(largest, (off / Enclosure(doubt, 2048)).upper());
    if (const auto sign = quick.sign(of)) {
      ++decided;
      EXPECT_EQ(sign, sign_of(of, exact)) << int(of) << spelled(sphere);
    }
  }
  return largest;
}

/// Scales a camera or ray's lengths, moves some far away.
double magnitude(Random& random) {
  return random.one_in(3) ? std::ldexp(1.0, int(random.integer(-150, 150))) : 1;
}

TEST(QuickLine, EnclosesCoefficientsOfGivenRays) {
  Random random(1);
  double largest = 0;
  int decided = 0;
  for (int k = 0; k < 100000 && !HasFailure(); ++k) {
    const Sizes sizes = random.one_in(8) ? Sizes::kAll : Sizes::kOrdinary;
    Ray ray = random_ray(random, sizes);
    const double far = magnitude(random);
    for (double* x : numbers_of(ray.origin)) *x *= far;
    if (!defects(ray).empty()) continue;
    const Sphere sphere = random.one_in(2) ? random_sphere(random, sizes)
                                           : nearly_touched(random, ray.origin, ray.direction);
    if (!defects(sphere).empty()) continue;
    const auto& [x, y, z] = ray.direction;
    largest = std::max(largest,
                       largest_share(ExactRay(ray), QuickLine::given({x, y, z}), sphere, decided));
  }
  EXPECT_LE(largest, 1);
  EXPECT_GE(largest, 1.0 / 32) << "a bound 32 times smaller is not exceeded";
  EXPECT_GE(decided, 200000);
}

TEST(QuickLine, EnclosesCoefficientsOfCamerasRays) {
  Random random(2);
  double largest = 0;
  int decided = 0;
  for (int k = 0; k < 40000 && !HasFailure(); ++k) {
    const Sizes sizes = random.one_in(8) ? Sizes::kAll : Sizes::kOrdinary;
    Camera camera = random_camera(random, sizes);
    const double scale = magnitude(random);
    for (double* x : {&camera.near, &camera.left, &camera.right, &camera.bottom, &camera.top}) {
      *x *= scale;
    }
    const Conventions conventions = random_conventions(random);
    if (!defects(camera, conventions).empty()) continue;
    const ExactCamera exact(camera, conventions);
    const ExactRay ray(exact, random_pixel(random, camera));
    const auto [alpha, beta] = quick_position(camera, conventions, ray.source().pixel);
    const QuickLine line = QuickLine::through(exact.impl()->quick, camera, alpha, beta);
    const Sphere sphere = random.one_in(2)
                              ? random_sphere(random, sizes)
                              : nearly_touched(random, camera.eye, {line.g.x, line.g.y, line.g.z});
    if (!defects(sphere).empty()) continue;
    largest = std::max(largest, largest_share(ray, line, sphere, decided));
  }
  EXPECT_LE(largest, 1);
  EXPECT_GE(largest, 1.0 / 64) << "a bound 64 times smaller is not exceeded";
  EXPECT_GE(decided, 60000);
}

/// Whether `near` is an upper bound of an error, given upper and lower bounds of it by balls, and
/// at most kNearErrorShare above it.
::testing::AssertionResult is_near(const Measured& near, const Enclosure& error) {
  const Enclosure bound = Enclosure(near.value, 512) * Enclosure(0x1p-53, 512);
  const Enclosure least = bound * (Enclosure(1) - Enclosure(kNearErrorShare, 512));
  if ((bound - error).certain_sign().value_or(0) >= 0 && (error - least).lower() >= 0) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << near.value;
}

TEST(NearError, IsAnUpperBoundAndNear) {
  Random random(3);
  int near_frames = 0, near_positions = 0, above = 0, conditions = 0;
  for (int k = 0; k < 30000 && !HasFailure(); ++k) {
    Camera camera = random_camera(random, Sizes::kOrdinary);
    const double far = std::ldexp(1.0, int(random.integer(0, 40)));
    for (double* x : numbers_of(camera.eye)) *x *= far;
    const Conventions conventions = random_conventions(random);
    if (!defects(camera, conventions).empty()) continue;
    SCOPED_TRACE(spelled(camera));
    const ExactCamera exact(camera, conventions);
    const auto near_axis = exact.frame_in_double_doubles().U;
    const Enclosure3 axis = exact.frame(300).U;
    const auto [x, y, z] = exact.rounded_frame().U;
    const UnitVector3 got{nudged(x, random.integer(-3, 3)), nudged(y, 1), z};
    if (const auto near = near_relative_error(got, near_axis)) {
      ++near_frames;
      EXPECT_TRUE(is_near(*near, norm(enclose_exactly(got) - axis) / norm(axis)));
      const Measured mutant{near->value * (1 - 2 * kNearErrorShare)};
      EXPECT_FALSE(is_near(mutant, norm(enclose_exactly(got) - axis) / norm(axis)));
    }
    const Pixel pixel = random_pixel(random, camera);
    const auto near = exact.plane_position_in_double_doubles(pixel);
    const Enclosure3 position = exact.plane_position(pixel, 512);
    for (const auto& [one, other] :
         {std::pair(near.x, position.x), std::pair(near.y, position.y)}) {
      ++near_positions;
      EXPECT_TRUE((one.enclosure() - other).contains_zero());
    }
    if (k % 8 != 0) continue;
    const ExactRay ray(exact, pixel);
    const double most = most_condition_of_pixel_point(ray),
                 condition = condition_of_pixel_point(ray);
    EXPECT_GE(most, condition);
    ++conditions;
    above += most > 64 * condition ? 1 : 0;
  }
  EXPECT_GE(near_frames, 20000);
  EXPECT_GE(near_positions, 40000);
  EXPECT_LE(above, conditions / 4);
}

TEST(NearError, OfHitsEnclosesTheirValues) {
  Random random(4);
  int hits = 0;
  for (int k = 0; k < 20000 && !HasFailure(); ++k) {
    const Camera camera = random_camera(random, Sizes::kOrdinary);
    const Conventions conventions = random_conventions(random);
    if (!defects(camera, conventions).empty()) continue;
    const ExactRay ray(ExactCamera(camera, conventions), random_pixel(random, camera));
    const Sphere sphere = random_sphere(random, Sizes::kOrdinary);
    const Intersection at = ray.intersect(sphere);
    if (at.hit_class != HitClass::kHit) continue;
    ++hits;
    const HitInDoubleDoubles near = hit_in_double_doubles(ray, sphere, at);
    const EnclosedRay exact = ray.enclose(512);
    EXPECT_TRUE((near.length.enclosure() - exact.length()).contains_zero());
    EXPECT_TRUE((near.parameter.enclosure() - exact.parameter(sphere, at)).contains_zero());
    EXPECT_TRUE((near.point.x.enclosure() - exact.point(sphere, at).x).contains_zero());
    EXPECT_TRUE((near.origin.z.enclosure() - exact.origin().z).contains_zero());
  }
  EXPECT_GE(hits, 2000);
}

TEST(NearError, InUlpIsThatByBalls) {
  Random random(5);
  for (int k = 0; k < 100000; ++k) {
    const double exact = any_double(random), given = nudged(exact, random.integer(-5, 5));
    for (const Precision precision : {Precision::kDouble, Precision::kSingle}) {
      ASSERT_EQ(ulp_error(given, exact, precision).value,
                ulp_error(given, Enclosure(exact, 128), precision).value)
          << hexfloat(exact) << " " << hexfloat(given);
    }
  }
}

}  // namespace
}  // namespace raycheck::reference
