// Condition numbers against differences of enclosures at changed inputs, intervals against balls,
// and where they are known by hand.

#include "reference/account/condition.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/reference/account/condition_cases.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Camera;
using scene::Sphere;

/// A camera's ray and a sphere: what a condition number is asked of.
struct CameraCase {
  Camera camera;
  scene::Conventions conventions;
  scene::Pixel pixel;
  std::vector<Sphere> spheres;  ///< One.

  ExactRay ray() const { return ExactRay(ExactCamera(camera, conventions), pixel); }
  std::string text() const { return spelled(camera) + spelled(spheres[0]); }
  std::vector<double*> inputs() { return inputs_of(camera, spheres); }
};

CameraCase random_case(Random& random, Sizes sizes) {
  CameraCase result;
  result.camera = random_camera(random, sizes);
  result.conventions = random_conventions(random);
  result.pixel = random_pixel(random, result.camera);
  result.spheres = {random_sphere(random, sizes)};
  return result;
}

using Value = std::function<std::vector<Enclosure>(const CameraCase&)>;

double norm_of(const std::vector<Enclosure>& v) {
  double squares = 0;
  for (const Enclosure& x : v) squares += x.upper() * x.upper();
  return std::sqrt(squares);
}

/// sum |dq/dx|_2 |x| / |q|_2 by central differences of doubles 2^-21 |x| apart, whose values are
/// enclosed at 400 bits: what a second derivative leaves is far below kDifferenceError.
double condition_by_differences(const CameraCase& at, const Value& value) {
  double sum = 0;
  CameraCase moved = at;
  for (double* const input : moved.inputs()) {
    const double x = *input;
    if (x == 0) continue;
    const double high = x * (1 + 0x1p-22);
    const double low = x * (1 - 0x1p-22);
    *input = high;
    std::vector<Enclosure> difference = value(moved);
    *input = low;
    const std::vector<Enclosure> other = value(moved);
    *input = x;
    for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= other[k];
    sum += norm_of(difference) * std::abs(x / (high - low));
  }
  return sum / norm_of(value(at));
}
constexpr double kDifferenceError = 0x1p-8;
/// Beyond, differences would leave too much; small ones lack nothing.
constexpr double kMostComparedCondition = 0x1p12;

std::vector<Enclosure> listed(const Enclosure3& v) { return {v.x, v.y, v.z}; }
std::vector<Enclosure> listed(const Enclosure& x) { return {x}; }

constexpr int kDifferenceBits = 400;

void expect_close(double condition, const CameraCase& at, const Value& value, const char* what,
                  int& compared) {
  if (condition <= kNegligibleCondition || condition > kMostComparedCondition) return;
  const double differences = condition_by_differences(at, value);
  EXPECT_LE(std::abs(condition - differences), kDifferenceError * differences)
      << what << " of " << at.text();
  ++compared;
}

struct Compared {
  int values = 0, hits = 0;
};

void expect_differences(const CameraCase& at, Compared& counts) {
  const ExactRay ray = at.ray();
  int& compared = counts.values;
  int& hits = counts.hits;
  const Sphere& sphere = at.spheres[0];
  const auto compare = [&](double condition, const char* what, auto value) {
    expect_close(
        condition, at,
        [&](const CameraCase& moved) {
          return listed(value(moved.ray().enclose(kDifferenceBits), moved.spheres[0]));
        },
        what, compared);
  };
  compare(condition_of_pixel_point(ray), "P",
          [](const auto& r, const auto&) { return r.pixel_point(); });
  compare(condition_of_direction(ray), "D",
          [](const auto& r, const auto&) { return r.direction(); });
  compare(condition_of_axial_distance(ray, sphere), "v",
          [](const auto& r, const auto& s) { return r.axial_distance(s); });
  compare(condition_of_half_chord_sq(ray, sphere), "d^2",
          [](const auto& r, const auto& s) { return r.half_chord_sq(s); });
  const Intersection met = ray.intersect(sphere);
  if (met.hit_class != HitClass::kHit) return;
  ++hits;
  compare(condition_of_parameter(ray, sphere, met), "s",
          [&](const auto& r, const auto& s) { return r.parameter(s, met); });
  compare(condition_of_point(ray, sphere, met), "Q",
          [&](const auto& r, const auto& s) { return r.point(s, met); });
}

TEST(CameraCondition, IsThatOfSmallDifferences) {
  Random random(1);
  Compared of_cameras;
  for (int k = 0; k < 40; ++k) {
    const CameraCase at = random_case(random, Sizes::kOrdinary);
    expect_differences(at, of_cameras);
    double worst = 0;
    for (const auto axis : {&EnclosedFrame::U, &EnclosedFrame::V, &EnclosedFrame::W}) {
      worst = std::max(worst, condition_by_differences(at, [axis](const CameraCase& moved) {
                         const ExactCamera other(moved.camera, moved.conventions);
                         return listed(other.frame(kDifferenceBits).*axis);
                       }));
    }
    if (worst >= kMostComparedCondition) continue;
    const double frame = condition_of_frame(ExactCamera(at.camera, at.conventions));
    EXPECT_LE(std::abs(frame - worst), kDifferenceError * worst);
  }
  EXPECT_GE(of_cameras.hits, 5);
  EXPECT_GE(of_cameras.values, 150);
}

/// Every condition number of a ray and a sphere.
std::vector<double> all_conditions(const ExactRay& ray, const Sphere& sphere) {
  std::vector<double> result = {condition_of_direction(ray),
                                condition_of_axial_distance(ray, sphere),
                                condition_of_half_chord_sq(ray, sphere)};
  if (ray.source().camera) result.push_back(condition_of_pixel_point(ray));
  const Intersection at = ray.intersect(sphere);
  if (at.hit_class != HitClass::kMiss) {
    result.push_back(condition_of_parameter(ray, sphere, at));
    result.push_back(condition_of_point(ray, sphere, at));
  }
  const RayStageConditions of_ray = stage_conditions(ray);
  const SphereStageConditions of_sphere = stage_conditions(ray, sphere, at);
  result.push_back(of_ray.direction);
  result.push_back(of_sphere.axial_distance);
  result.push_back(of_sphere.half_chord_sq);
  for (const auto& one : {of_ray.pixel_point, of_sphere.root, of_sphere.point}) {
    if (one) result.push_back(*one);
  }
  return result;
}

/// So large that squares are no doubles: intervals then show nothing, and balls are asked.
void enlarge(const std::vector<double*>& lengths) {
  for (double* const x : lengths) *x = std::ldexp(*x, 700);
}

/// How many finite condition numbers agreed.
int compare(const std::vector<double>& ordinary, const std::vector<double>& enlarged,
            const std::string& what) {
  EXPECT_EQ(ordinary.size(), enlarged.size()) << what;
  int finite = 0;
  for (std::size_t k = 0; k < enlarged.size(); ++k) {
    expect_same_condition(ordinary[k], enlarged[k], std::to_string(k) + " of " + what);
    if (std::isfinite(enlarged[k])) ++finite;
  }
  return finite;
}

TEST(ConditionArithmetics, AgreeAboutGivenRaysAndThoseOfCameras) {
  for (const Sizes sizes : {Sizes::kSmallIntegers, Sizes::kOrdinary}) {
    Random random(2);
    int given = 0, of_cameras = 0;
    for (int k = 0; k < 200; ++k) {
      scene::Ray ray = random_ray(random, sizes);
      Sphere sphere = random_sphere(random, sizes);
      const std::string of_given = spelled(ray) + spelled(sphere);
      const std::vector<double> ordinary = all_conditions(ExactRay(ray), sphere);
      auto& [origin, direction] = ray;
      enlarge({&origin.x, &origin.y, &origin.z, &direction.x, &direction.y, &direction.z,
               &sphere.centre.x, &sphere.centre.y, &sphere.centre.z, &sphere.radius});
      given += compare(ordinary, all_conditions(ExactRay(ray), sphere), of_given);
      if (k % 3 != 0) continue;
      const CameraCase at = random_case(random, sizes);
      CameraCase enlarged = at;
      enlarge(enlarged.inputs());
      const auto conditions = [](const CameraCase& one) {
        std::vector<double> all = all_conditions(one.ray(), one.spheres[0]);
        all.push_back(condition_of_frame(ExactCamera(one.camera, one.conventions)));
        return all;
      };
      of_cameras += compare(conditions(at), conditions(enlarged), at.text());
    }
    EXPECT_GE(given, 1000);
    EXPECT_GE(of_cameras, 300);
  }
}

TEST(CameraCondition, OfTheFrameGrowsAsUpNearsTheViewDirection) {
  // w = (1 - 1, 0, 10) and u = up x w = (10 angle, up_z w_x - up_x w_z, ...): changes of E_x and
  // A_x move w_x by 1 each, so that U turns by 1 / (10 angle) with each.
  for (const double angle : {0x1p-10, 0x1p-20, 0x1p-30}) {
    const Camera camera{{1, 0, 10}, {1, 0, 0}, {0, angle, 1}, -1, {}, -1, 1, -1, 1, 3, 3};
    expect_condition(condition_of_frame(ExactCamera(camera, {})), Big(2) / (10 * Big(angle)),
                     "the frame");
  }
}

TEST(Condition, IsInfiniteAtATangent) {
  const ExactRay ray(scene::Ray{{-5, 1, 0}, {1, 0, 0}});
  const Sphere sphere{{0, 0, 0}, 1};
  EXPECT_EQ(condition_of_parameter(ray, sphere, kTangent), kUnbounded);
  EXPECT_EQ(condition_of_point(ray, sphere, kTangent), kUnbounded);
  EXPECT_EQ(condition_of_half_chord_sq(ray, sphere), kUnbounded);
  EXPECT_LT(condition_of_axial_distance(ray, sphere), 3);
}

TEST(Condition, IsInfiniteOfAValueThatSmallChangesMoveFromZero) {
  // v = T.D = 0, of terms that cancel.
  const ExactRay ray(scene::Ray{{0, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(condition_of_axial_distance(ray, {{3, -3, 0}, 1}), kUnbounded);
  // Q = 0, the world's origin.
  const ExactRay to_origin(scene::Ray{{-1, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(condition_of_point(to_origin, {{2, 0, 0}, 2}, kSmallerHit), kUnbounded);
  // Beyond the doubles: s = 2^-1075 of numbers near 1.
  const ExactRay close(scene::Ray{{-1, 0x1p-537, 0}, {1, 0, 0}});
  EXPECT_EQ(condition_of_parameter(close, {{0, 0, 0}, 1}, kSmallerHit), kUnbounded);
}

TEST(Condition, IsZeroOfAZeroThatNoSmallChangeMoves) {
  // T = (0, 3, 0) and D = (1, 0, 0): relative changes leave v = 0.
  const ExactRay ray(scene::Ray{{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(condition_of_axial_distance(ray, {{0, 3, 0}, 1}), 0);
  // A point on the axis stays there.
  EXPECT_EQ(condition_of_half_chord_sq(ray, {{5, 0, 0}, 0}), 0);
  // The direction (1, 0, 0) keeps its sign and its axis.
  EXPECT_LE(condition_of_direction(ray), kNegligibleCondition);
}

}  // namespace
}  // namespace raycheck::reference
