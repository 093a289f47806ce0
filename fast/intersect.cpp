#include "fast/intersect.h"

#include <stdexcept>
#include <string>

#include "fast/internal/batch_arrays.h"
#include "fast/ray_by_ray.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::fast {
namespace {

constexpr const IntersectMethod* kMethods[] = {
#define RAYCHECK_ADDRESS(name) &k##name,
    RAYCHECK_INTERSECT_METHODS(RAYCHECK_ADDRESS)
#undef RAYCHECK_ADDRESS
};

bool all_finite(const Vectors& vectors) {
  // x - x is 0 for a finite x and NaN otherwise, so that the loops have no branches.
  double sum = 0;
  for (const double x : vectors.x) sum += x - x;
  for (const double y : vectors.y) sum += y - y;
  for (const double z : vectors.z) sum += z - z;
  return sum == 0;
}

std::invalid_argument refusal(const Rays& rays, std::size_t k) {
  return std::invalid_argument("ray " + std::to_string(k) +
                               " of the batch: " + scene::sentences(scene::defects(rays.at(k))));
}

bool all_nonzero(const Vectors& vectors) {
  bool nonzero = true;
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    nonzero &= vectors.x[k] != 0 || vectors.y[k] != 0 || vectors.z[k] != 0;
  }
  return nonzero;
}

}  // namespace

std::span<const IntersectMethod* const> intersect_methods() { return kMethods; }

void require_valid(const Rays& rays, const scene::Sphere& sphere) {
  scene::require_valid(sphere);
  if (all_finite(rays.origin) && all_finite(rays.direction) && all_nonzero(rays.direction)) return;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (!scene::defects(rays.at(k)).empty()) throw refusal(rays, k);
  }
}

std::pair<BatchInput, HitArrays> intersect_by(BatchKernel kernel, const Rays& rays,
                                              const scene::Sphere& sphere, scene::HitRule rule,
                                              Hits& hits) {
  scene::require_valid(sphere);
  hits.resize(rays.size());
  const auto& [origin, direction] = rays;
  const BatchInput input = {rays.size(),
                            {{origin.x.data(), origin.y.data(), origin.z.data()},
                             {direction.x.data(), direction.y.data(), direction.z.data()}},
                            sphere,
                            rule};
  const HitArrays answers = {hits.hit.data(),
                             hits.parameter.data(),
                             {hits.point.x.data(), hits.point.y.data(), hits.point.z.data()}};
  if (!kernel(input, answers)) require_valid(rays, sphere);
  return {input, answers};
}

std::vector<std::optional<FirstHit>> nearest_spheres(const IntersectMethod& method,
                                                     const Rays& rays,
                                                     std::span<const scene::Sphere> spheres,
                                                     scene::HitRule rule) {
  std::vector<std::optional<FirstHit>> nearest(rays.size());
  Hits hits;
  for (std::size_t index = 0; index < spheres.size(); ++index) {
    scene::poll();
    method.intersect(rays, spheres[index], rule, hits);
    for (std::size_t k = 0; k < rays.size(); ++k) {
      if (!hits.hit[k]) continue;
      if (nearest[k] && nearest[k]->parameter <= hits.parameter[k]) continue;
      nearest[k] = {index, hits.parameter[k]};
    }
  }
  return nearest;
}

}  // namespace raycheck::fast
