#include <algorithm>
#include <limits>

#include "tools/check/check.h"

namespace raycheck::tools {
namespace {

void keep_worst(std::vector<ExcludedHit>& worst) {
  std::stable_sort(worst.begin(), worst.end(), [](const ExcludedHit& a, const ExcludedHit& b) {
    return a.in_radii > b.in_radii;
  });
  if (worst.size() > kKeptExcluded) worst.resize(kKeptExcluded);
}

}  // namespace

ExcludedOfSphere ExcludedHits::all() const {
  ExcludedOfSphere sum;
  for (const ExcludedOfSphere& one : spheres) {
    sum.hits += one.hits;
    sum.excluded += one.excluded;
    sum.moved += one.moved;
  }
  return sum;
}

void ExcludedHits::merge(const ExcludedHits& other) {
  spheres.resize(std::max(spheres.size(), other.spheres.size()));
  for (std::size_t k = 0; k < other.spheres.size(); ++k) {
    spheres[k].hits += other.spheres[k].hits;
    spheres[k].excluded += other.spheres[k].excluded;
    spheres[k].moved += other.spheres[k].moved;
  }
  worst.insert(worst.end(), other.worst.begin(), other.worst.end());
  keep_worst(worst);
}

ExcludedHits excluded_hits(properties::Trial& trial) {
  ExcludedHits found;
  const scene::Conventions& conventions = trial.conventions();
  if (conventions.valid.is_usual()) return found;
  const auto& spheres = trial.scene().spheres;
  found.spheres.resize(spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      const reference::ExactRay& exact = trial.exact_ray(ray);
      const reference::Intersection without = exact.intersect(spheres[k], conventions.root);
      if (!reference::counts_as_hit(without.hit_class, conventions.tangent)) continue;
      ++found.spheres[k].hits;
      const reference::Intersection with = trial.exact_intersection(ray, k);
      if (reference::counts_as_hit(with.hit_class, conventions.tangent)) {
        found.spheres[k].moved += with == without ? 0 : 1;
        continue;
      }
      ++found.spheres[k].excluded;
      const double s = exact.rounded_parameter(spheres[k], without, trial.precision());
      const double radius = spheres[k].radius;
      found.worst.push_back({trial.place(ray, k), s,
                             radius > 0 ? s / radius : std::numeric_limits<double>::infinity()});
    }
  }
  keep_worst(found.worst);
  return found;
}

}  // namespace raycheck::tools
