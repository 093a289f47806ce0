#pragma once

// The formulas of cameras, rays and spheres, as templates over a CGAL kernel K. They are
// instantiated with the kernels of reference/internal/kernels.h, the differentiating kernels of
// reference/account/internal/condition_impl.h and the symbolic kernel of
// reference/account/closed_form.cpp. Internal to reference/.

#include <cstdint>

#include "reference/internal/kernels.h"
#include "scene/camera.h"
#include "scene/conventions.h"

namespace raycheck::reference {

// The inputs as numbers of a kernel. Each double is lifted once, in the order of the members.
template <class K>
struct CameraInputs {
  typename K::Vector_3 eye, look_at, up;
  typename K::FT near, left, right, bottom, top;
};
template <class K>
struct RayInputs {
  typename K::Vector_3 origin, direction;
};
template <class K>
struct SphereInputs {
  typename K::Vector_3 centre;
  typename K::FT radius;
};

template <class Lift>
CameraInputs<typename Lift::Kernel> lift_camera(const Lift& lift, const scene::Camera& camera) {
  return {lift_vector(lift, camera.eye),
          lift_vector(lift, camera.look_at),
          lift_vector(lift, camera.up),
          lift(camera.near),
          lift(camera.left),
          lift(camera.right),
          lift(camera.bottom),
          lift(camera.top)};
}
template <class Lift>
RayInputs<typename Lift::Kernel> lift_ray(const Lift& lift, const scene::Ray& ray) {
  return {lift_vector(lift, ray.origin), lift_vector(lift, ray.direction)};
}
template <class Lift>
SphereInputs<typename Lift::Kernel> lift_sphere(const Lift& lift, const scene::Sphere& sphere) {
  return {lift_vector(lift, sphere.centre), lift(sphere.radius)};
}

/// The camera axes, orthonormal and right-handed.
template <class K>
struct Axes {
  typename K::Vector_3 U, V, W;
};

/// W = (E - A)/|E - A|, U = (up x W)/|up x W|, V = W x U. Let w = E - A and u = up x w. The only
/// square roots are |w| and |u|, both of rationals, since up x W = u/|w|, and |w| cancels in U.
template <class K>
Axes<K> camera_axes(const CameraInputs<K>& camera) {
  const typename K::Vector_3 w = camera.eye - camera.look_at;
  const typename K::Vector_3 u = CGAL::cross_product(camera.up, w);
  const typename K::Vector_3 W = w / first_root(typename K::FT(w * w));
  const typename K::Vector_3 U = u / second_root(typename K::FT(u * u));
  return {U, CGAL::cross_product(W, U), W};
}

/// A camera under one kernel.
template <class K>
struct CameraNumbers {
  CameraInputs<K> inputs;
  Axes<K> axes;
};

template <class Lift>
CameraNumbers<typename Lift::Kernel> camera_numbers(const Lift& lift, const scene::Camera& camera) {
  const auto inputs = lift_camera(lift, camera);
  return {inputs, camera_axes(inputs)};
}

/// A pixel's index along one side of the image, and the steps there.
struct PixelIndex {
  double index;
  scene::PixelSteps steps;
  bool is_from_high;
};

/// low + (index + offset)/steps (high - low), where the index may count from `high`. Multiplying
/// before dividing makes the enclosure of a dyadic coordinate exact; 0 is the most important case.
template <class FT, class Lift>
FT plane_coordinate(const Lift& lift, const FT& low, const FT& high, const PixelIndex& at) {
  const auto [offset, steps] = at.steps;
  const double index = at.is_from_high ? at.steps.turned() - at.index : at.index;
  const int parts = offset == 0 ? 1 : 2;  // of a step
  const auto count = [&](double x) {
    return lift_count(lift, static_cast<std::int64_t>(parts * x));
  };
  const FT extent = high - low;
  return low + count(index + offset) * extent / count(steps);
}

/// alpha(i) and beta(j) of a pixel.
template <class FT>
struct PlanePosition {
  FT alpha, beta;
};

/// A pixel's column and row.
struct PixelIndices {
  PixelIndex column, row;
};
inline PixelIndices indices_of(const scene::Camera& camera, const scene::Conventions& conventions,
                               const scene::Pixel& pixel) {
  const auto at = [&](std::int64_t index, std::int64_t count, bool is_from_high) {
    return PixelIndex{static_cast<double>(index), scene::pixel_steps(conventions.samples, count),
                      is_from_high};
  };
  return {at(pixel.i, camera.width, false),
          at(pixel.j, camera.height, conventions.rows == scene::Rows::kTopFirst)};
}

template <class K, class Lift>
PlanePosition<typename K::FT> plane_position(const Lift& lift, const CameraInputs<K>& inputs,
                                             const scene::Camera& camera,
                                             const scene::Conventions& conventions,
                                             const scene::Pixel& pixel) {
  const auto [column, row] = indices_of(camera, conventions, pixel);
  return {plane_coordinate(lift, inputs.left, inputs.right, column),
          plane_coordinate(lift, inputs.bottom, inputs.top, row)};
}

/// n W + alpha U + beta V: from the eye to the pixel point.
template <class K>
typename K::Vector_3 to_pixel_point(const typename K::FT& n,
                                    const PlanePosition<typename K::FT>& position,
                                    const Axes<K>& axes) {
  return n * axes.W + position.alpha * axes.U + position.beta * axes.V;
}

/// The line base + lambda g, with a = |g|^2. For a camera, base = E and g = n W + alpha U + beta V,
/// so that lambda = 1 is the pixel point P; a = l^2 does not depend on the axes, which are
/// orthonormal.
template <class K>
struct Line {
  typename K::Vector_3 base;
  typename K::Vector_3 g;
  typename K::FT a;
  bool starts_at_g;  ///< The ray's origin is base + g (rays from pixels), not base.
  bool is_unit;      ///< The ray's direction is g/|g| (a camera's rays), not g.
};

template <class K>
Line<K> line_through(const CameraNumbers<K>& numbers, const PlanePosition<typename K::FT>& position,
                     scene::Origin origin) {
  const typename K::FT& n = numbers.inputs.near;
  return {numbers.inputs.eye, to_pixel_point<K>(n, position, numbers.axes),
          n * n + position.alpha * position.alpha + position.beta * position.beta,
          origin == scene::Origin::kPixel, true};
}

template <class K, class Lift>
Line<K> camera_line(const Lift& lift, const CameraNumbers<K>& numbers, const scene::Camera& camera,
                    const scene::Conventions& conventions, const scene::Pixel& pixel) {
  return line_through(numbers, plane_position(lift, numbers.inputs, camera, conventions, pixel),
                      conventions.origin);
}

template <class K>
Line<K> given_line(const RayInputs<K>& ray) {
  return {ray.origin, ray.direction, ray.direction * ray.direction, false, false};
}

/// A line and a sphere: f = C - base.
template <class K>
struct LineAndSphere {
  const Line<K>& line;
  typename K::Vector_3 f;
  typename K::FT radius;
};

template <class K>
LineAndSphere<K> line_and_sphere(const Line<K>& line, const SphereInputs<K>& sphere) {
  return {line, sphere.centre - line.base, sphere.radius};
}

/// T = C - L, L the ray's origin.
template <class K>
typename K::Vector_3 to_centre(const LineAndSphere<K>& pair) {
  return pair.line.starts_at_g ? typename K::Vector_3(pair.f - pair.line.g) : pair.f;
}

/// b = T.g. The points L + mu g on the sphere are those at the roots mu of a mu^2 - 2 b mu + c = 0.
template <class K>
typename K::FT linear_coefficient(const LineAndSphere<K>& pair) {
  return to_centre(pair) * pair.line.g;
}

/// c = |T|^2 - r^2; negative if L is inside the sphere.
template <class K>
typename K::FT constant_coefficient(const LineAndSphere<K>& pair) {
  const typename K::Vector_3 t = to_centre(pair);
  return typename K::FT(t * t) - pair.radius * pair.radius;
}

/// b^2 - a c, computed by Lagrange's identity as a r^2 - |f x g|^2, which does not cancel for far
/// spheres and does not depend on the ray's origin on the line.
template <class K>
typename K::FT discriminant(const LineAndSphere<K>& pair) {
  const typename K::Vector_3 moment = CGAL::cross_product(pair.f, pair.line.g);
  return pair.line.a * pair.radius * pair.radius - typename K::FT(moment * moment);
}

// A ray's values, for numbers that have square roots.

/// The ray's origin: P or E, or a given ray's origin.
template <class K>
typename K::Vector_3 ray_origin(const Line<K>& line) {
  return line.starts_at_g ? typename K::Vector_3(line.base + line.g) : line.base;
}

/// |g|; for a camera's ray, l = |P - E|.
template <class K>
typename K::FT ray_length(const Line<K>& line) {
  using CGAL::sqrt;
  return sqrt(line.a);
}

/// D
template <class K>
typename K::Vector_3 unit_direction(const Line<K>& line) {
  return line.g / ray_length(line);
}

/// v = T.D
template <class K>
typename K::FT axial_distance(const LineAndSphere<K>& pair) {
  return linear_coefficient(pair) / ray_length(pair.line);
}

/// d^2 = r^2 - (|T|^2 - v^2)
template <class K>
typename K::FT half_chord_sq(const LineAndSphere<K>& pair) {
  return discriminant(pair) / pair.line.a;
}

/// middle + sign sqrt(half_sq); the sign of a tangent is 0.
template <class FT>
FT root_of(const FT& middle, const FT& half_sq, int root_sign) {
  using CGAL::sqrt;
  if (root_sign == 0) return middle;
  return root_sign < 0 ? FT(middle - sqrt(half_sq)) : FT(middle + sqrt(half_sq));
}

/// (v -+ d) |g|
template <class K>
typename K::FT scaled_distance(const LineAndSphere<K>& pair, int root_sign) {
  return root_of(linear_coefficient(pair), discriminant(pair), root_sign);
}

/// s: v -+ d for a camera's ray, (v -+ d)/|g| for a given ray.
template <class K>
typename K::FT ray_parameter(const LineAndSphere<K>& pair, int root_sign) {
  const typename K::FT numerator = scaled_distance(pair, root_sign);
  return numerator / (pair.line.is_unit ? ray_length(pair.line) : pair.line.a);
}

/// Q = L + s D
template <class K>
typename K::Vector_3 hit_point(const LineAndSphere<K>& pair, int root_sign) {
  const typename K::FT mu = scaled_distance(pair, root_sign) / pair.line.a;
  return ray_origin(pair.line) + mu * pair.line.g;
}

}  // namespace raycheck::reference
