// Condition numbers of camera's rays, against differences of enclosures at changed inputs, and
// intervals against balls.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "reference/account/condition.h"
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

  ExactRay ray() const { return {ExactCamera(camera, conventions), pixel}; }
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
  for (double* const input : inputs_of(moved.camera, moved.spheres)) {
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
  if (condition > kMostComparedCondition) return;
  const double differences = condition_by_differences(at, value);
  EXPECT_LE(std::abs(condition - differences), kDifferenceError * differences)
      << what << " of " << spelled(at.camera) << spelled(at.spheres[0]);
  ++compared;
}

TEST(CameraCondition, IsThatOfSmallDifferences) {
  Random random(1);
  int compared = 0;
  int hits = 0;
  for (int k = 0; k < 40; ++k) {
    const CameraCase at = random_case(random, Sizes::kOrdinary);
    const ExactRay ray = at.ray();
    const ExactCamera camera(at.camera, at.conventions);
    double worst = 0;
    for (const auto axis : {&EnclosedFrame::U, &EnclosedFrame::V, &EnclosedFrame::W}) {
      worst = std::max(worst, condition_by_differences(at, [axis](const CameraCase& moved) {
                         const ExactCamera other(moved.camera, moved.conventions);
                         return listed(other.frame_within(0, kDifferenceBits).*axis);
                       }));
    }
    if (worst < kMostComparedCondition) {
      EXPECT_LE(std::abs(condition_of_frame(camera) - worst), kDifferenceError * worst);
    }
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
    if (met.hit_class != HitClass::kHit) continue;
    ++hits;
    compare(condition_of_parameter(ray, sphere, met), "s",
            [&](const auto& r, const auto& s) { return r.parameter(s, met); });
    compare(condition_of_point(ray, sphere, met), "Q",
            [&](const auto& r, const auto& s) { return r.point(s, met); });
  }
  EXPECT_GE(hits, 5);
  EXPECT_GE(compared, 150);
}

/// Every condition number of a ray and a sphere.
std::vector<double> all_conditions(const ExactRay& ray, const Sphere& sphere, Arithmetic by) {
  std::vector<double> result = {condition_of_direction(ray, by),
                                condition_of_axial_distance(ray, sphere, by),
                                condition_of_half_chord_sq(ray, sphere, by)};
  if (ray.source().camera) result.push_back(condition_of_pixel_point(ray, by));
  const Intersection at = ray.intersect(sphere);
  if (at.hit_class != HitClass::kMiss) {
    result.push_back(condition_of_parameter(ray, sphere, at, by));
    result.push_back(condition_of_point(ray, sphere, at, by));
  }
  const RayStageConditions of_ray = stage_conditions(ray, by);
  const SphereStageConditions of_sphere = stage_conditions(ray, sphere, at, by);
  result.push_back(of_ray.direction);
  result.push_back(of_sphere.axial_distance);
  result.push_back(of_sphere.half_chord_sq);
  for (const auto& one : {of_ray.pixel_point, of_sphere.root, of_sphere.point}) {
    if (one) result.push_back(*one);
  }
  return result;
}

/// How many finite condition numbers agreed.
int compare_arithmetics(const ExactRay& ray, const Sphere& sphere, const std::string& what) {
  const auto filtered = all_conditions(ray, sphere, Arithmetic::kFiltered);
  const auto balls = all_conditions(ray, sphere, Arithmetic::kBallsOnly);
  int finite = 0;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    expect_same_condition(filtered[k], balls[k], std::to_string(k) + " of " + what);
    if (std::isfinite(balls[k])) ++finite;
  }
  return finite;
}

TEST(ConditionArithmetics, AgreeAboutGivenRaysAndThoseOfCameras) {
  for (const Sizes sizes : {Sizes::kSmallIntegers, Sizes::kOrdinary, Sizes::kAll}) {
    Random random(2);
    int given = 0, of_cameras = 0;
    for (int k = 0; k < 200; ++k) {
      const scene::Ray ray = random_ray(random, sizes);
      const Sphere sphere = random_sphere(random, sizes);
      given += compare_arithmetics(ExactRay(ray), sphere, spelled(ray) + spelled(sphere));
      if (k % 3 != 0) continue;
      const CameraCase at = random_case(random, sizes);
      of_cameras +=
          compare_arithmetics(at.ray(), at.spheres[0], spelled(at.camera) + spelled(at.spheres[0]));
      const ExactCamera camera(at.camera, at.conventions);
      expect_same_condition(condition_of_frame(camera),
                            condition_of_frame(camera, Arithmetic::kBallsOnly),
                            "frame of " + spelled(at.camera));
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

}  // namespace
}  // namespace raycheck::reference
