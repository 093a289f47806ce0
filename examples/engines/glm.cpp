// GLM's intersectRaySphere, which asks for unit directions: whoever uses it sees to that. Debian:
// libglm-dev.

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>
#include <glm/vec3.hpp>

#include "adapter.h"

using namespace raycheck;

static glm::dvec3 dvec3(const Vector& v) { return {v.x, v.y, v.z}; }

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const double length = glm::length(dvec3(ray.direction));
  double distance = 0;
  if (!glm::intersectRaySphere(dvec3(ray.origin), dvec3(ray.direction) / length,
                               dvec3(sphere.centre), sphere.radius * sphere.radius, distance)) {
    return std::nullopt;
  }
  return hit_at(ray, distance / length);
}

// Its epsilon is the absolute 2^-52: what is not farther than that is behind the origin.
RAYCHECK_CANDIDATE(.name = "glm", .root = Root::nearest, .tangent = Tangent::hit,
                   .intersect = intersect, .level = Level::ordinary, .smallest_length = 0x1p-20,
                   .largest_length = 0x1p200)
