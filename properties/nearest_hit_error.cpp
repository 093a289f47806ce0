#include "properties/nearest_hit_error.h"

#include <algorithm>
#include <stdexcept>

#include "properties/sphere_choice.h"
#include "reference/ray_error.h"
#include "reference/visibility/visibility.h"

namespace raycheck::properties {
namespace {

bool may_be_unjudged(Trial& trial, std::size_t ray) {
  const auto& spheres = trial.scene().spheres;
  return std::any_of(spheres.begin(), spheres.end(), [&](const scene::Sphere& sphere) {
    return is_unjudged(trial.exact_ray(ray).intersect(sphere, trial.conventions()),
                       trial.conventions().tangent);
  });
}

bool are_equally_near(Trial& trial, std::size_t ray, std::size_t sphere) {
  const auto exact = trial.exact_ray(ray).nearest(trial.scene().spheres, trial.conventions());
  return exact && std::find(exact->ties.begin(), exact->ties.end(), sphere) != exact->ties.end();
}

Wrong wrong_of(Trial& trial, std::size_t ray, std::int32_t seen, std::optional<std::size_t> got) {
  if (seen == reference::kNoSphere) return got ? Wrong::kFalseHit : Wrong::kNot;
  if (!got) return Wrong::kMissed;
  const bool right = *got == static_cast<std::size_t>(seen) || are_equally_near(trial, ray, *got);
  return right ? Wrong::kNot : Wrong::kWrongSphere;
}

Standing standing_of(Trial& trial, std::size_t ray, Index got) {
  if (!trial.inside_domain() || may_be_unjudged(trial, ray)) return Standing::kNotJudged;
  return excuse(trial, ray, got, trial.excused_change()).standing();
}

}  // namespace

std::vector<NearestHitError> nearest_hit_errors(Trial& trial, std::span<const std::int32_t> seen) {
  std::vector<NearestHitError> errors(seen.size());
  for (std::size_t ray = 0; ray < errors.size(); ++ray) {
    NearestHitError& error = errors[ray];
    const std::optional<std::size_t> got = trial.nearest().at(ray);
    error.wrong = wrong_of(trial, ray, seen[ray], got);
    if (error.wrong != Wrong::kNot) {
      error.standing = standing_of(trial, ray, got);
    } else if (got) {
      const scene::Sphere& sphere = trial.scene().spheres[*got];
      const HitAnswer* const hit = find_hit(trial.hits(*got), ray);
      if (hit == nullptr) throw std::runtime_error("candidate misses the sphere it sees");
      const reference::ExactRay& exact = trial.exact_ray(ray);
      error.ulp =
          reference::parameter_error(exact, sphere, exact.intersect(sphere, trial.conventions()),
                                     hit->parameter, trial.precision());
    }
  }
  return errors;
}

}  // namespace raycheck::properties
