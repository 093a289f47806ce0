#ifndef RAYCHECK_REFERENCE_FORMULAS_H_
#define RAYCHECK_REFERENCE_FORMULAS_H_

// The formulas of cameras, rays and spheres, written once over a CGAL kernel K and instantiated
// with the kernels of reference/kernels.h and the symbolic one of reference/closed_form.cpp.
// Internal to reference/.

#include <cstdint>

#include "reference/kernels.h"
#include "scene/camera.h"
#include "scene/conventions.h"

namespace raycheck::reference {

/// The camera axes, orthonormal and right-handed.
template <class K>
struct Axes {
  typename K::Vector_3 U, V, W;
};

/// W = (E - A)/|E - A|, U = (up x W)/|up x W|, V = W x U. With w = E - A and u = up x w, the only
/// square roots are |w| and |u|, both of rationals: up x W is u/|w|, and the |w| cancels in U.
template <class K, class Lift>
Axes<K> camera_axes(const Lift& lift, const scene::Camera& camera) {
  const typename K::Vector_3 w =
      lift_vector<K>(lift, camera.eye) - lift_vector<K>(lift, camera.look_at);
  const typename K::Vector_3 u = CGAL::cross_product(lift_vector<K>(lift, camera.up), w);
  const typename K::Vector_3 W = w / first_root(typename K::FT(w * w));
  const typename K::Vector_3 U = u / second_root(typename K::FT(u * u));
  return {U, CGAL::cross_product(W, U), W};
}

/// low + index/(count-1) (high - low), or low + (index+1/2)/count (high - low). Multiplying before
/// dividing makes the enclosure exact wherever the coordinate is dyadic, 0 above all.
template <class Lift>
auto plane_coordinate(const Lift& lift, double low, double high, std::int64_t index,
                      std::int64_t count, scene::Samples samples) {
  const auto first = lift(low);
  const auto extent = lift(high) - first;
  if (samples == scene::Samples::kEdges) {
    return first + lift_count(lift, index) * extent / lift_count(lift, count - 1);
  }
  const auto two = lift_count(lift, 2);
  return first + (two * lift_count(lift, index) + lift_count(lift, 1)) * extent /
                     (two * lift_count(lift, count));
}

/// alpha(i) and beta(j) of a pixel.
template <class FT>
struct PlanePosition {
  FT alpha, beta;
};

template <class K, class Lift>
PlanePosition<typename K::FT> plane_position(const Lift& lift, const scene::Camera& camera,
                                             const scene::Conventions& conventions,
                                             const scene::Pixel& pixel) {
  const std::int64_t row =
      conventions.rows == scene::Rows::kBottomFirst ? pixel.j : camera.height - 1 - pixel.j;
  return {
      plane_coordinate(lift, camera.left, camera.right, pixel.i, camera.width, conventions.samples),
      plane_coordinate(lift, camera.bottom, camera.top, row, camera.height, conventions.samples)};
}

/// The line base + lambda g, with a = |g|^2. From a camera, base = E and g = n W + alpha U + beta
/// V, so that lambda = 1 is the pixel point P; a = l^2 needs no axes, since they are orthonormal.
template <class K>
struct Line {
  typename K::Vector_3 base;
  typename K::Vector_3 g;
  typename K::FT a;
  bool starts_at_g;  ///< The ray's origin is base + g (a pixel ray) instead of base.
};

template <class K, class Lift>
Line<K> camera_line(const Lift& lift, const scene::Camera& camera,
                    const scene::Conventions& conventions, const Axes<K>& axes,
                    const scene::Pixel& pixel) {
  const auto position = plane_position<K>(lift, camera, conventions, pixel);
  const typename K::FT n = lift(camera.near);
  return {lift_vector<K>(lift, camera.eye),
          n * axes.W + position.alpha * axes.U + position.beta * axes.V,
          n * n + position.alpha * position.alpha + position.beta * position.beta,
          conventions.origin == scene::Origin::kPixel};
}

template <class K, class Lift>
Line<K> given_line(const Lift& lift, const scene::Ray& ray) {
  const typename K::Vector_3 direction = lift_vector<K>(lift, ray.direction);
  return {lift_vector<K>(lift, ray.origin), direction, direction * direction, false};
}

/// A line and a sphere: f = C - base.
template <class K>
struct LineAndSphere {
  const Line<K>& line;
  typename K::Vector_3 f;
  typename K::FT radius;
};

template <class K, class Lift>
LineAndSphere<K> line_and_sphere(const Lift& lift, const Line<K>& line,
                                 const scene::Sphere& sphere) {
  return {line, lift_vector<K>(lift, sphere.centre) - line.base, lift(sphere.radius)};
}

/// T = C - L, L the ray's origin.
template <class K>
typename K::Vector_3 to_centre(const LineAndSphere<K>& pair) {
  return pair.line.starts_at_g ? typename K::Vector_3(pair.f - pair.line.g) : pair.f;
}

/// The ray meets the sphere at the roots mu of a mu^2 - 2 b mu + c = 0 (L + mu g on the sphere).
/// b = T.g
template <class K>
typename K::FT linear_coefficient(const LineAndSphere<K>& pair) {
  return to_centre(pair) * pair.line.g;
}

/// c = |T|^2 - r^2: negative inside the sphere.
template <class K>
typename K::FT constant_coefficient(const LineAndSphere<K>& pair) {
  const typename K::Vector_3 t = to_centre(pair);
  return typename K::FT(t * t) - pair.radius * pair.radius;
}

/// b^2 - a c, by Lagrange's identity a r^2 - |f x g|^2, which does not cancel for far spheres and
/// is the same wherever on the line the ray starts.
template <class K>
typename K::FT discriminant(const LineAndSphere<K>& pair) {
  const typename K::Vector_3 moment = CGAL::cross_product(pair.f, pair.line.g);
  return pair.line.a * pair.radius * pair.radius - typename K::FT(moment * moment);
}

}  // namespace raycheck::reference

#endif  // RAYCHECK_REFERENCE_FORMULAS_H_
