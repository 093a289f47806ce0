#ifndef RAYCHECK_FAST_INTERSECT_BATCH_H_
#define RAYCHECK_FAST_INTERSECT_BATCH_H_

// The loop that turns a method's roots of one ray and one sphere into hits. Internal to fast/.

#include <cmath>

#include "fast/eigen.h"
#include "fast/intersect.h"
#include "fast/ray_by_ray.h"

namespace raycheck::fast {

using Eigen::Vector3d;

/// The roots of a t^2 - 2 b t + c = 0 from its discriminant: q = b + sign(b) sqrt(disc) does not
/// cancel, the roots are q/a and c/q (Numerical Recipes 5.6). q = 0 only for a double root 0. A
/// comparison chooses the sign, not the sign bit, which would exchange the roots at b = -0.
inline Roots roots_by_q(double a, double b, double c, double discriminant) {
  const bool forward = b >= 0;
  const double root = std::sqrt(discriminant);
  const double q = forward ? b + root : b - root;
  const double one = q / a;
  const double other = q == 0 ? 0.0 : c / q;
  return {b / std::sqrt(a), discriminant / a, forward ? other : one, forward ? one : other};
}

/// The answer of one ray; without a hit `at` means nothing.
struct Chosen {
  bool hit;
  Hit at;
};

/// From the roots to the answer, under the conventions. Free of branches where a compiler can be.
inline Chosen choose(const Roots& found, const Vector3d& origin, const Vector3d& direction,
                     scene::Root root, scene::Tangent tangent) {
  const bool tangent_counts = tangent != scene::Tangent::kMiss;
  const bool larger_counts = root == scene::Root::kNearest;
  const bool meets = tangent_counts ? found.half_chord_sq >= 0 : found.half_chord_sq > 0;
  const bool take_larger = larger_counts && !(found.smaller >= 0);
  const double s = take_larger ? found.larger : found.smaller;
  return {meets && s >= 0,
          {s,
           {origin.x() + s * direction.x(), origin.y() + s * direction.y(),
            origin.z() + s * direction.z()}}};
}

template <class Method>
void intersect_batch(const Rays& rays, const scene::Sphere& sphere, scene::Root root,
                     scene::Tangent tangent, Hits& hits) {
  require_valid(rays, sphere);
  const std::size_t count = rays.size();
  hits.resize(count);
  const Vector3d centre = eigen(sphere.centre);
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d origin(rays.origin.x[k], rays.origin.y[k], rays.origin.z[k]);
    const Vector3d direction(rays.direction.x[k], rays.direction.y[k], rays.direction.z[k]);
    const Roots found = Method::roots(origin, direction, centre, sphere.radius);
    const Chosen chosen = choose(found, origin, direction, root, tangent);
    hits.hit[k] = chosen.hit;
    hits.parameter[k] = chosen.at.parameter;
    hits.point.x[k] = chosen.at.point.x;
    hits.point.y[k] = chosen.at.point.y;
    hits.point.z[k] = chosen.at.point.z;
  }
}

template <class Method>
std::optional<Hit> intersect_one(const scene::Ray& ray, const scene::Sphere& sphere,
                                 scene::Root root, scene::Tangent tangent) {
  const Vector3d origin = eigen(ray.origin);
  const Vector3d direction = eigen(ray.direction);
  const Roots found = Method::roots(origin, direction, eigen(sphere.centre), sphere.radius);
  const Chosen chosen = choose(found, origin, direction, root, tangent);
  return chosen.hit ? std::optional(chosen.at) : std::nullopt;
}

template <class Method>
Roots roots_of(const scene::Ray& ray, const scene::Sphere& sphere) {
  return Method::roots(eigen(ray.origin), eigen(ray.direction), eigen(sphere.centre),
                       sphere.radius);
}

}  // namespace raycheck::fast

#endif  // RAYCHECK_FAST_INTERSECT_BATCH_H_
