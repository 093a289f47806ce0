// OpenVDB's math::Ray::intersects(center, radius, t0, t1), in doubles. Debian: libopenvdb-dev. For
// a hit it returns both times, clipped to the times of the ray, by default 1e-9 to the largest
// double. A clipped time is not an intersection. Directions need not be unit. Source:
// openvdb/math/Ray.h. Silent on tangents.

#include <openvdb/math/Ray.h>

#include "adapter.h"

using namespace raycheck;
using Vec = openvdb::math::Vec3<Real>;

#ifdef FAR  // only the far root
constexpr Culling kCulling = Culling::front_faces;
#else
constexpr Culling kCulling = Culling::none;
#endif

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const openvdb::math::Ray<Real> line(to<Vec, Real>(ray.origin), to<Vec, Real>(ray.direction));
  Real t0 = 0, t1 = 0;
  if (!line.intersects(to<Vec, Real>(sphere.centre), static_cast<Real>(sphere.radius), t0, t1)) {
    return std::nullopt;
  }
  if (kCulling == Culling::none && t0 != line.t0()) return Hit{t0, {}};
  if (t1 != line.t1()) return Hit{t1, {}};
  return std::nullopt;
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision, .roots = Roots::declared,
                   .valid = {.t_min = openvdb::math::Delta<Real>::value(), .culling = kCulling},
                   .returns = Returns::parameter)
