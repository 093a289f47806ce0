#include <algorithm>
#include <chrono>
#include <limits>

#include "scene/interruption.h"
#include "scene/validate.h"
#include "tools/check/judgement.h"

namespace raycheck::tools {
namespace {

/// Enough rays to hide a batch's fixed costs, few enough to stay in the cache.
constexpr std::size_t kBatch = 2048;
constexpr int kRepetitions = 7;
/// Spheres timed; a ray against more costs in proportion.
constexpr std::size_t kSpheres = 64;

template <class Work>
double best_ns(Work work) {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kRepetitions; ++k) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::nano> elapsed =
        std::chrono::steady_clock::now() - start;
    best = std::min(best, elapsed.count());
  }
  return best;
}

/// Rays that overflowed are judged, but not timed.
bool all_valid(const fast::Rays& rays) {
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const scene::Ray ray = {{rays.origin.x[k], rays.origin.y[k], rays.origin.z[k]},
                            {rays.direction.x[k], rays.direction.y[k], rays.direction.z[k]}};
    if (!scene::defects(ray).empty()) return false;
  }
  return true;
}

}  // namespace

Timing time_methods(const MethodPair& methods, const scene::Scene& scene,
                    const scene::Conventions& conventions,
                    const std::vector<scene::Pixel>& pixels) {
  Timing timing;
  fast::Rays rays;
  if (scene.camera) {
    const auto make = conventions.origin == scene::Origin::kPixel ? methods.rays->pixel_rays
                                                                  : methods.rays->focal_rays;
    if (make == nullptr || pixels.empty()) return timing;
    std::vector<scene::Pixel> batch(kBatch);
    for (std::size_t k = 0; k < kBatch; ++k) batch[k] = pixels[k % pixels.size()];
    timing.make = best_ns([&] { make(*scene.camera, conventions, batch, rays); }) / kBatch;
  } else {
    rays.resize(kBatch);
    for (std::size_t k = 0; k < kBatch; ++k) {
      const scene::Ray& ray = scene.rays[k % scene.rays.size()];
      rays.origin.x[k] = ray.origin.x;
      rays.origin.y[k] = ray.origin.y;
      rays.origin.z[k] = ray.origin.z;
      rays.direction.x[k] = ray.direction.x;
      rays.direction.y[k] = ray.direction.y;
      rays.direction.z[k] = ray.direction.z;
    }
  }
  const std::size_t spheres = std::min(scene.spheres.size(), kSpheres);
  if (spheres == 0 || !all_valid(rays)) return timing;
  fast::Hits hits;
  const double elapsed = best_ns([&] {
    for (std::size_t k = 0; k < spheres; ++k) {
      scene::poll();
      methods.intersect->intersect(rays, scene.spheres[k], conventions.hit_rule(), hits);
    }
  });
  timing.intersect =
      elapsed / kBatch / static_cast<double>(spheres) * static_cast<double>(scene.spheres.size());
  return timing;
}

}  // namespace raycheck::tools
