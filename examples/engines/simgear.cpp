// SimGear's intersects(SGRay, SGSphere), in doubles: whether they intersect. Debian:
// libsimgear-dev. Source: simgear/math/SGIntersect.hxx, SGRay.hxx. Silent on tangents; directions
// of any length.

#include <simgear/math/SGGeometry.hxx>

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const SGRayd line(to<SGVec3d>(ray.origin), to<SGVec3d>(ray.direction));
  const SGSphered ball(to<SGVec3d>(sphere.centre), sphere.radius);
  if (!intersects(line, ball)) return std::nullopt;
  return Hit{};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .returns = Returns::class_only)
