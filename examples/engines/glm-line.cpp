// GLM's intersectLineSphere, in doubles: both points where the line through two points meets the
// sphere. The two points are kFar directions apart here. Debian: libglm-dev.
// Source: glm/gtx/intersect.hpp. Silent on tangents and on the order of points; the adapter takes
// the first along the line.

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>
#include <glm/vec3.hpp>

#include "adapter.h"

using namespace raycheck;
using glm::dvec3;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const dvec3 start = to<dvec3>(ray.origin), direction = to<dvec3>(ray.direction);
  dvec3 point1, normal1, point2, normal2;
  if (!glm::intersectLineSphere(start, start + direction * kFar, to<dvec3>(sphere.centre),
                                sphere.radius, point1, normal1, point2, normal2)) {
    return std::nullopt;
  }
  const dvec3 first = glm::dot(point2 - point1, direction) < 0 ? point2 : point1;
  return Hit{.point = {first.x, first.y, first.z}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .roots = Roots::declared, .valid = kLine,
                   .returns = Returns::point)
