#include "reference/account/condition.h"

#include <algorithm>

#include "reference/account/internal/condition_impl.h"

namespace raycheck::reference {
namespace {

template <class Value, class IsZero>
double line_condition(const ExactRay& ray, Value value, IsZero is_zero) {
  const auto quantity = [&](const auto& lift) { return value(line_of(lift, ray.source())); };
  return ray.source().camera ? condition_number<kCameraInputs>(quantity, is_zero)
                             : condition_number<kGivenInputs>(quantity, is_zero);
}

template <class Value, class IsZero>
double pair_condition(const ExactRay& ray, const scene::Sphere& sphere, Value value,
                      IsZero is_zero) {
  scene::require_valid(sphere);
  const auto quantity = [&](const auto& lift) {
    const auto line = line_of(lift, ray.source());
    return value(line_and_sphere(line, lift_sphere(lift, sphere)));
  };
  return ray.source().camera ? condition_number<kCameraInputs>(quantity, is_zero)
                             : condition_number<kGivenInputs>(quantity, is_zero);
}

bool never() { return false; }

}  // namespace

std::optional<double> narrow_condition(const Sensitivity<Interval>& sensitivity) {
  const auto& [size, sum] = sensitivity;
  if (is_exact_zero(sum)) return 0;
  const Interval condition = sum / size;
  const double bound = condition.sup();
  if (bound <= kNegligibleCondition) return bound;
  if (!std::isfinite(bound) || !(bound - condition.inf() <= kConditionWidth * bound)) {
    return std::nullopt;
  }
  return bound;
}

double condition_of_frame(const ExactCamera& camera) {
  const auto axis_condition = [&](auto axis) {
    const auto quantity = [&](const auto& lift) {
      return axis(camera_numbers(lift, camera.camera()).axes);
    };
    return condition_number<kCameraInputs>(quantity, never);
  };
  return std::max({axis_condition([](const auto& axes) { return axes.U; }),
                   axis_condition([](const auto& axes) { return axes.V; }),
                   axis_condition([](const auto& axes) { return axes.W; })});
}

double condition_of_pixel_point(const ExactRay& ray) {
  return line_condition(
      ray, [](const auto& line) { return line.base + line.g; },
      [&] { return is_zero(ray.pixel_point()); });
}

double condition_of_direction(const ExactRay& ray) {
  return line_condition(
      ray, [](const auto& line) { return unit_direction(line); }, never);
}

double condition_of_axial_distance(const ExactRay& ray, const scene::Sphere& sphere) {
  return pair_condition(
      ray, sphere, [](const auto& pair) { return axial_distance(pair); },
      [&] { return axial_distance_is_zero(ray, sphere); });
}

double condition_of_half_chord_sq(const ExactRay& ray, const scene::Sphere& sphere) {
  return pair_condition(
      ray, sphere, [](const auto& pair) { return half_chord_sq(pair); },
      [&] { return half_chord_is_zero(ray, sphere); });
}

double condition_of_parameter(const ExactRay& ray, const scene::Sphere& sphere,
                              const Intersection& intersection) {
  const int sign = root_sign(intersection);
  if (sign == 0) return std::numeric_limits<double>::infinity();
  return pair_condition(
      ray, sphere, [sign](const auto& pair) { return ray_parameter(pair, sign); },
      [&] { return is_exact_zero(ray.parameter(sphere, intersection)); });
}

double condition_of_point(const ExactRay& ray, const scene::Sphere& sphere,
                          const Intersection& intersection) {
  const int sign = root_sign(intersection);
  if (sign == 0) return std::numeric_limits<double>::infinity();
  return pair_condition(
      ray, sphere, [sign](const auto& pair) { return hit_point(pair, sign); },
      [&] { return is_zero(ray.point(sphere, intersection)); });
}

}  // namespace raycheck::reference
