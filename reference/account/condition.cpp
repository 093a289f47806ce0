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

double most_condition_of_pixel_point(const ExactRay& ray) {
  const scene::Camera& camera = ray.source().camera->camera;
  const double most = by_double_doubles([&] {
    const auto line = line_in_double_doubles(ray);
    const auto inputs = lift_camera(DoubleDoubleLift{}, camera);
    const auto length = [](const auto& v) { return sqrt(DoubleDouble(v * v)); };
    const auto sum = [](const auto& v) { return abs(v.x()) + abs(v.y()) + abs(v.z()); };
    const DoubleDoubleKernel::Vector_3 w = inputs.eye - inputs.look_at;
    const DoubleDouble w_size = length(w);
    const DoubleDouble u_size =
        length(DoubleDoubleKernel::Vector_3(CGAL::cross_product(inputs.up, w)));
    const DoubleDouble positions = sum(inputs.eye) + sum(inputs.look_at);
    const DoubleDouble turned =
        positions * (DoubleDouble(1) / w_size + length(inputs.up) / u_size) +
        sum(inputs.up) * w_size / u_size;
    const DoubleDouble all = sum(inputs.eye) + sqrt(line.a) * turned + abs(inputs.near) +
                             abs(inputs.left) + abs(inputs.right) + abs(inputs.bottom) +
                             abs(inputs.top);
    return (all / length(DoubleDoubleKernel::Vector_3(line.base + line.g))).upper();
  });
  // condition_of_pixel_point() is too large by at most these.
  const double bound = most * (1 + 2 * kConditionWidth) + 2 * kNegligibleCondition;
  return std::isnan(bound) ? std::numeric_limits<double>::infinity() : bound;
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
