// Condition numbers of single steps: reference/account/condition.h.

#include <limits>

#include "reference/account/condition.h"
#include "reference/account/internal/condition_impl.h"
#include "reference/error_measure.h"

namespace raycheck::reference {
namespace {

/// A lift, its kernel, and the kernel of the inputs to differentiate by.
template <class Lift>
using KernelOf = typename std::decay_t<Lift>::Kernel;
template <class Lift>
using BaseKernelOf = typename std::decay_t<Lift>::BaseKernel;

template <class Lift>
typename KernelOf<Lift>::Vector_3 no_vector(const Lift& lift) {
  return {lift.constant(0), lift.constant(0), lift.constant(0)};
}

double pixel_point_condition(const ExactRay& ray) {
  const auto& camera = *ray.source().camera;
  const auto quantity = [&](const auto& lift) {
    using K = KernelOf<decltype(lift)>;
    const auto numbers = with_numbers(lift.base(), camera, [](const auto& kept) { return kept; });
    const auto at = plane_position(lift.base(), numbers.inputs, camera.camera, camera.conventions,
                                   ray.source().pixel);
    const typename K::Vector_3 eye = lift.input(numbers.inputs.eye);
    const typename K::FT near = lift.input(numbers.inputs.near);
    const typename K::FT alpha = lift.input(at.alpha);
    const typename K::FT beta = lift.input(at.beta);
    const typename K::Vector_3 U = lift.input(numbers.axes.U);
    const typename K::Vector_3 V = lift.input(numbers.axes.V);
    const Axes<K> axes{U, V, lift.input(numbers.axes.W)};
    return eye + to_pixel_point<K>(near, {alpha, beta}, axes);
  };
  return condition_number<kCameraInputs>(quantity, [&] { return is_zero(ray.pixel_point()); });
}

double direction_condition(const ExactRay& ray) {
  const auto quantity = [&](const auto& lift) {
    using K = KernelOf<decltype(lift)>;
    const auto line = line_of(lift.base(), ray.source());
    const bool from_eye = ray.source().camera != nullptr;
    const typename K::Vector_3 from = from_eye ? lift.input(line.base) : no_vector(lift);
    const typename K::Vector_3 to = lift.input(
        from_eye ? typename BaseKernelOf<decltype(lift)>::Vector_3(line.base + line.g) : line.g);
    return unit_direction(given_line(RayInputs<K>{from, to - from}));
  };
  return condition_number<kCameraInputs>(quantity, [] { return false; });
}

/// The condition number of value(T, D, r), for a sphere and a ray.
template <class Value, class IsZero>
double seen_condition(const ExactRay& ray, const scene::Sphere& sphere, Value value,
                      IsZero is_zero) {
  const auto quantity = [&](const auto& lift) {
    using K = KernelOf<decltype(lift)>;
    const auto line = line_of(lift.base(), ray.source());
    const auto seen = lift_sphere(lift.base(), sphere);
    const SphereInputs<K> centre{lift.input(to_centre(line_and_sphere(line, seen))),
                                 lift.input(seen.radius)};
    const auto from_origin =
        given_line(RayInputs<K>{no_vector(lift), lift.input(unit_direction(line))});
    return value(line_and_sphere(from_origin, centre));
  };
  return condition_number<kCameraInputs>(quantity, is_zero);
}

double root_condition(const ExactRay& ray, const scene::Sphere& sphere, const Intersection& at) {
  const int sign = root_sign(at);
  const auto quantity = [&](const auto& lift) {
    const auto line = line_of(lift.base(), ray.source());
    const auto pair = line_and_sphere(line, lift_sphere(lift.base(), sphere));
    const auto v = lift.input(axial_distance(pair));
    return root_of(v, sign == 0 ? v : lift.input(half_chord_sq(pair)), sign);
  };
  return condition_number<kCameraInputs>(quantity,
                                         [&] { return is_exact_zero(ray.parameter(sphere, at)); });
}

double hit_point_condition(const ExactRay& ray, const scene::Sphere& sphere,
                           const Intersection& at) {
  const auto quantity = [&](const auto& lift) {
    using K = KernelOf<decltype(lift)>;
    const auto line = line_of(lift.base(), ray.source());
    const auto pair = line_and_sphere(line, lift_sphere(lift.base(), sphere));
    const typename K::Vector_3 origin = lift.input(ray_origin(line));
    const typename K::FT distance =
        lift.input(scaled_distance(pair, root_sign(at)) / ray_length(line));
    return typename K::Vector_3(origin + distance * lift.input(unit_direction(line)));
  };
  return condition_number<kCameraInputs>(quantity, [&] { return is_zero(ray.point(sphere, at)); });
}

}  // namespace

RayStageConditions stage_conditions(const ExactRay& ray) {
  RayStageConditions result;
  if (ray.source().camera) result.pixel_point = pixel_point_condition(ray);
  result.direction = direction_condition(ray);
  return result;
}

SphereStageConditions stage_conditions(const ExactRay& ray, const scene::Sphere& sphere,
                                       const Intersection& intersection) {
  scene::require_valid(sphere);
  SphereStageConditions result;
  result.axial_distance = seen_condition(
      ray, sphere, [](const auto& pair) { return axial_distance(pair); },
      [&] { return axial_distance_is_zero(ray, sphere); });
  result.half_chord_sq = seen_condition(
      ray, sphere, [](const auto& pair) { return half_chord_sq(pair); },
      [&] { return half_chord_is_zero(ray, sphere); });
  if (intersection.hit_class == HitClass::kMiss) return result;
  result.root = root_condition(ray, sphere, intersection);
  result.point = hit_point_condition(ray, sphere, intersection);
  return result;
}

namespace {

constexpr int kTextbookBits = 256;

Enclosure distance_of(const EnclosedRay& ray, const scene::Sphere& sphere) {
  return norm(enclose_exactly(sphere.centre) - ray.origin());
}

double upper_ratio(const Enclosure& value, const Enclosure& over) {
  return over.contains_zero() ? std::numeric_limits<double>::infinity() : (value / over).upper();
}

}  // namespace

double textbook_condition(const ExactRay& ray, const scene::Sphere& sphere,
                          const Intersection& intersection) {
  const EnclosedRay enclosed = ray.enclose(kTextbookBits);
  const Enclosure radius(sphere.radius, kTextbookBits);
  const Enclosure distance = distance_of(enclosed, sphere);
  const Enclosure v = enclosed.axial_distance(sphere);
  const Enclosure d = sqrt(enclosed.half_chord_sq(sphere));
  const Enclosure s = intersection.root == WhichRoot::kSmaller ? v - d : v + d;
  const Enclosure squares =
      Enclosure(2) * distance * abs(v) + distance * distance + radius * radius;
  return upper_ratio(distance + d, abs(s)) + upper_ratio(squares, Enclosure(2) * d * abs(s));
}

double distance_in_radii(const ExactRay& ray, const scene::Sphere& sphere) {
  return upper_ratio(distance_of(ray.enclose(kTextbookBits), sphere),
                     Enclosure(sphere.radius, kTextbookBits));
}

double half_chord_share(const ExactRay& ray, const scene::Sphere& sphere) {
  const Enclosure radius(sphere.radius, kTextbookBits);
  return upper_ratio(abs(ray.enclose(kTextbookBits).half_chord_sq(sphere)), radius * radius);
}

double condition_of_computed_point(const ExactRay& ray, const scene::Sphere& sphere,
                                   const Intersection& intersection) {
  return condition_of_point(ray, sphere, intersection) +
         hit_point_condition(ray, sphere, intersection);
}

}  // namespace raycheck::reference
