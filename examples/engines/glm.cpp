// GLM's intersectRaySphere with a distance (in doubles; glm-float.cpp: in floats), which requires
// unit directions. Debian: libglm-dev. Source: glm/gtx/intersect.hpp. Silent on tangents, on the
// root (it is the nearest), and on its epsilon, the ulp of 1: hits at smaller distances count as
// behind the origin.

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>
#include <glm/vec3.hpp>

#include "adapter.h"

using namespace raycheck;
using Vec = glm::vec<3, Real>;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const auto radius = static_cast<Real>(sphere.radius);
  Real distance = 0;
  if (!glm::intersectRaySphere(to<Vec, Real>(ray.origin), to<Vec, Real>(ray.direction),
                               to<Vec, Real>(sphere.centre), radius * radius, distance)) {
    return std::nullopt;
  }
  return Hit{distance, {}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision,
                   .directions = Directions::unit, .returns = Returns::distance)
