#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/intersect.hpp>
#include <glm/vec3.hpp>

#include "fast/ray_by_ray.h"
#include "tools/peers/peers.h"

namespace raycheck::peers {
namespace {

template <class Triple>
glm::dvec3 dvec3(const Triple& v) {
  return {v.x, v.y, v.z};
}

struct Glm {
  const scene::Sphere& sphere;

  std::optional<fast::Hit> answer(const scene::Ray& ray, scene::Root /*root*/,
                                  scene::Tangent /*tangent*/) const {
    double s = 0;
    if (!glm::intersectRaySphere(dvec3(ray.origin), dvec3(ray.direction), dvec3(sphere.centre),
                                 sphere.radius * sphere.radius, s)) {
      return std::nullopt;
    }
    return fast::hit_at(ray, s);
  }
};

/// Its epsilon is the absolute 2^-52: a hit that is not further away counts as behind the origin.
constexpr double kSmallestLength = 0x1p-20;

}  // namespace

extern const fast::IntersectMethod kGlm = {
    .name = "glm",
    .sentence = "glm::intersectRaySphere: v = T.D, d^2 = r^2 - (|T|^2 - v^2), s > epsilon",
    .intersect = fast::intersect_ray_by_ray<Glm>,
    .intersect_one = fast::intersect_one_ray<Glm>,
    .max_ulp = kSquaresMaxUlp,
    .max_point_ulp = kSquaresMaxUlp,
    .not_kept = "far spheres, grazing rays, origins on the surface",
    .domain = {.smallest_length = kSmallestLength},
    .contract = {.unit_direction = true,
                 .root = scene::Root::kNearest,
                 .tangent = scene::Tangent::kHit},
};

}  // namespace raycheck::peers
