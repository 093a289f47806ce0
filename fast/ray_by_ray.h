#pragma once

// Makes an IntersectMethod from a type Method that answers one ray at a time, in any number type. A
// Method is made from a sphere, `Method{sphere}`, and has the member
// std::optional<Hit> answer(const scene::Ray&, scene::HitRule) const.

#include <cstddef>
#include <optional>

#include "fast/intersect.h"

namespace raycheck::fast {

/// Throws std::invalid_argument naming the first field that makes the input invalid.
void require_valid(const Rays& rays, const scene::Sphere& sphere);

/// The hit at parameter s: Q = L + s D in doubles.
inline Hit hit_at(const scene::Ray& ray, double s) {
  return {s,
          {ray.origin.x + s * ray.direction.x, ray.origin.y + s * ray.direction.y,
           ray.origin.z + s * ray.direction.z}};
}

template <class Method>
void intersect_ray_by_ray(const Rays& rays, const scene::Sphere& sphere, scene::HitRule rule,
                          Hits& hits) {
  require_valid(rays, sphere);
  const Method method{sphere};
  hits.resize(rays.size());
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const std::optional<Hit> hit = method.answer(rays.at(k), rule);
    hits.set(k, hit.has_value(), hit.value_or(Hit{}));
  }
}

template <class Method>
std::optional<Hit> intersect_one_ray(const scene::Ray& ray, const scene::Sphere& sphere,
                                     scene::HitRule rule) {
  return Method{sphere}.answer(ray, rule);
}

}  // namespace raycheck::fast
