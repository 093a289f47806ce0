#ifndef RAYCHECK_FAST_INTERSECT_BATCH_H_
#define RAYCHECK_FAST_INTERSECT_BATCH_H_

// From a method's roots of one ray and one sphere, in any type of number, to its answers to one ray
// and to a batch. Internal to fast/.

#include <cmath>

#include "fast/chosen.h"
#include "fast/eigen.h"
#include "fast/ray_by_ray.h"

namespace raycheck::fast {

using Eigen::Vector3d;

template <class Number>
using Vector3Of = Eigen::Matrix<Number, 3, 1>;

/// A type of number that std:: and its own namespace have no square root of specialises this.
template <class Number>
Number square_root(const Number& x) {
  using std::sqrt;
  return sqrt(x);
}

/// Roots, in the type of number that a method reckons with.
template <class Number>
struct RootsOf {
  Number axial_distance;
  Number half_chord_sq;
  Number smaller;
  Number larger;
};

/// The roots of a t^2 - 2 b t + c = 0 from its discriminant: q = b + sign(b) sqrt(disc) does not
/// cancel, the roots are q/a and c/q (Numerical Recipes 5.6). q = 0 only for a double root 0. A
/// comparison chooses the sign, not the sign bit, which would exchange the roots at b = -0.
template <class Number>
RootsOf<Number> roots_by_q(const Number& a, const Number& b, const Number& c,
                           const Number& discriminant) {
  const bool forward = b >= Number(0);
  const Number root = square_root(discriminant);
  const Number q = forward ? b + root : b - root;
  const Number one = q / a;
  const Number other = q == Number(0) ? Number(0) : c / q;
  return {b / square_root(a), discriminant / a, forward ? other : one, forward ? one : other};
}

/// The root that the conventions choose, and the point there. Free of branches where a compiler can
/// be.
template <class Number>
Chosen choose(const RootsOf<Number>& found, const Vector3Of<Number>& origin,
              const Vector3Of<Number>& direction, scene::Root root, scene::Tangent tangent) {
  const Number zero(0);
  const bool tangent_counts = tangent != scene::Tangent::kMiss;
  const bool larger_counts = root == scene::Root::kNearest;
  const bool meets = tangent_counts ? found.half_chord_sq >= zero : found.half_chord_sq > zero;
  const bool take_larger = larger_counts && !(found.smaller >= zero);
  const Number s = take_larger ? found.larger : found.smaller;
  return {meets && s >= zero,
          {static_cast<double>(s),
           {static_cast<double>(origin.x() + s * direction.x()),
            static_cast<double>(origin.y() + s * direction.y()),
            static_cast<double>(origin.z() + s * direction.z())}}};
}

/// A method that has Method::roots(origin, direction, centre, radius) in the type Method::Number.
template <class Method>
struct FromRoots {
  using Number = typename Method::Number;

  static RootsOf<Number> roots(const Vector3d& origin, const Vector3d& direction,
                               const Vector3d& centre, double radius) {
    return Method::roots(origin.cast<Number>(), direction.cast<Number>(), centre.cast<Number>(),
                         static_cast<Number>(radius));
  }

  static Chosen answer(const Vector3d& origin, const Vector3d& direction, const Vector3d& centre,
                       double radius, scene::Root root, scene::Tangent tangent) {
    return choose<Number>(roots(origin, direction, centre, radius), origin.cast<Number>(),
                          direction.cast<Number>(), root, tangent);
  }
};

// The functions of an IntersectMethod, of an Answerer: a type with an answer() as FromRoots has.
// Flattened: a call would pass vectors through memory, and reckon what the answer does not need.

template <class Answerer>
[[gnu::flatten]] void intersect_batch(const Rays& rays, const scene::Sphere& sphere,
                                      scene::Root root, scene::Tangent tangent, Hits& hits) {
  require_valid(rays, sphere);
  const std::size_t count = rays.size();
  hits.resize(count);
  const Vector3d centre = eigen(sphere.centre);
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d origin(rays.origin.x[k], rays.origin.y[k], rays.origin.z[k]);
    const Vector3d direction(rays.direction.x[k], rays.direction.y[k], rays.direction.z[k]);
    const Chosen chosen = Answerer::answer(origin, direction, centre, sphere.radius, root, tangent);
    hits.hit[k] = chosen.hit;
    hits.parameter[k] = chosen.at.parameter;
    hits.point.x[k] = chosen.at.point.x;
    hits.point.y[k] = chosen.at.point.y;
    hits.point.z[k] = chosen.at.point.z;
  }
}

template <class Answerer>
[[gnu::flatten]] std::optional<Hit> intersect_one(const scene::Ray& ray,
                                                  const scene::Sphere& sphere, scene::Root root,
                                                  scene::Tangent tangent) {
  const Chosen chosen = Answerer::answer(eigen(ray.origin), eigen(ray.direction),
                                         eigen(sphere.centre), sphere.radius, root, tangent);
  return chosen.hit ? std::optional(chosen.at) : std::nullopt;
}

template <class Answerer>
Roots roots_of(const scene::Ray& ray, const scene::Sphere& sphere) {
  const auto found =
      Answerer::roots(eigen(ray.origin), eigen(ray.direction), eigen(sphere.centre), sphere.radius);
  return {static_cast<double>(found.axial_distance), static_cast<double>(found.half_chord_sq),
          static_cast<double>(found.smaller), static_cast<double>(found.larger)};
}

}  // namespace raycheck::fast

#endif  // RAYCHECK_FAST_INTERSECT_BATCH_H_
