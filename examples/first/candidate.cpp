#include <raycheck/candidate.hpp>

#include "hit_sphere.h"  // yours

using namespace raycheck;

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const double s = hit_sphere(ray.origin, ray.direction, sphere.centre, sphere.radius);
  if (s < 0) return {};
  return Hit{s, along(ray.origin, s, ray.direction)};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::hit, .intersect = intersect)
