// OpenVDB's math::Ray::intersects(center, radius), in doubles: whether the ray, from time 1e-9 on,
// intersects the sphere. Debian: libopenvdb-dev.
// Source: openvdb/math/Ray.h. Silent on tangents.

#include <openvdb/math/Ray.h>

#include "adapter.h"

using namespace raycheck;
using openvdb::Vec3d;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const openvdb::math::Ray<double> line(to<Vec3d>(ray.origin), to<Vec3d>(ray.direction));
  if (!line.intersects(to<Vec3d>(sphere.centre), sphere.radius)) return std::nullopt;
  return Hit{};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .roots = Roots::declared,
                   .valid = {.t_min = openvdb::math::Delta<double>::value()},
                   .returns = Returns::class_only)
