#include "properties/laws/certificate.h"

#include <algorithm>
#include <cstddef>

#include "reference/interval_ray.h"

namespace raycheck::properties {

bool is_certain(const Law& law, const Candidate& candidate, const scene::Box<Case>& cases,
                DefectKind kind) {
  using reference::HitClass;
  const scene::Scene &least = cases.least.scene, &greatest = cases.greatest.scene;
  const bool missed = kind.wrong == Wrong::kMissed;
  const bool is_class = judges_decisions(law) && law.quantity == kind.quantity &&
                        kind.quantity == Quantity::kClass &&
                        (missed || kind.wrong == Wrong::kFalseHit);
  const scene::Conventions conventions = candidate.declared.over(least.conventions);
  // A length stays in the domain where both ends do, but for what begins at 0, and for distances.
  const bool has_points = std::any_of(least.spheres.begin(), least.spheres.end(),
                                      [](const scene::Sphere& one) { return one.radius == 0; });
  if (!candidate.classes_in || !is_class || !conventions.valid.is_usual() || least.camera ||
      has_points) {
    return false;
  }
  const double change =
      excused_change(candidate.unit_roundoff) *
      (candidate.level == Level::kOrdinary ? kOrdinaryDistance * kOrdinaryDistance : 1);
  for (std::size_t k = 0; k < least.rays.size(); ++k) {
    const scene::Box<scene::Ray> rays = {least.rays[k], greatest.rays[k]};
    for (std::size_t m = 0; m < least.spheres.size(); ++m) {
      const scene::Box<scene::Sphere> spheres = {least.spheres[m], greatest.spheres[m]};
      const auto answers = candidate.classes_in(rays, spheres, conventions.hit_rule());
      if (missed ? answers.hit : answers.miss) continue;
      const auto truth = reference::intersection_in(rays, spheres, change, conventions.root);
      if (truth && truth->hit_class == (missed ? HitClass::kHit : HitClass::kMiss)) return true;
    }
  }
  return false;
}

}  // namespace raycheck::properties
