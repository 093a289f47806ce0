// GLM's intersectRaySphere with a position and a normal, in doubles; the direction is documented
// as normalized. Debian: libglm-dev. Source: glm/gtx/intersect.hpp. For what is undocumented
// see glm.cpp.

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>
#include <glm/vec3.hpp>

#include "adapter.h"

using namespace raycheck;
using glm::dvec3;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  dvec3 point, normal;
  if (!glm::intersectRaySphere(to<dvec3>(ray.origin), to<dvec3>(ray.direction),
                               to<dvec3>(sphere.centre), sphere.radius, point, normal)) {
    return std::nullopt;
  }
  return Hit{.point = {point.x, point.y, point.z}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .directions = Directions::unit,
                   .returns = Returns::point)
