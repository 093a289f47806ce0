#include "properties/sphere_choice.h"

#include <algorithm>

#include "reference/account/nearby_choice.h"

namespace raycheck::properties {

bool is_right(const Choice& choice) {
  if (!choice.exact) return !choice.got;
  return choice.got == kSomeSphere ||
         (choice.got && std::find(choice.exact->ties.begin(), choice.exact->ties.end(),
                                  *choice.got) != choice.exact->ties.end());
}

Wrong wrong_of(const Choice& choice) {
  return is_right(choice) ? Wrong::kNot
         : !choice.exact  ? Wrong::kFalseHit
         : !choice.got    ? Wrong::kMissed
                          : Wrong::kWrongSphere;
}

Excuse excuse(Trial& trial, std::size_t ray, Index got, double change) {
  using reference::FirstMet;
  const FirstMet claim{!got                 ? FirstMet::What::kNothing
                       : got == kSomeSphere ? FirstMet::What::kSomething
                                            : FirstMet::What::kSphere,
                       got.value_or(0)};
  return excuse_of(
      right_nearby(trial.exact_ray(ray), trial.scene().spheres, trial.neighbourhood(change), claim),
      change);
}

SpheresMet spheres_met(Trial& trial) {
  SpheresMet met{std::vector<std::uint32_t>(trial.ray_count()),
                 std::vector<bool>(trial.ray_count())};
  const scene::Tangent tangent = trial.conventions().tangent;
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    for (const Meeting& meeting : trial.exact_meetings(sphere)) {
      const reference::Intersection& at = meeting.intersection;
      if (is_unjudged(at, tangent)) met.is_unjudged[meeting.ray] = true;
      if (counts_as_hit(at.hit_class, tangent)) ++met.count[meeting.ray];
    }
  }
  return met;
}

}  // namespace raycheck::properties
