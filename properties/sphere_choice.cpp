#include "properties/sphere_choice.h"

#include <algorithm>

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

namespace {

/// Whether a relative change of the inputs by so much may flip the class of one of the two spheres,
/// or their order.
bool may_flip(Trial& trial, const Choice& choice, double change) {
  const auto& spheres = trial.scene().spheres;
  const reference::ExactRay& ray = trial.exact_ray(choice.ray);
  const auto class_may_flip = [&](std::size_t sphere) {
    return ray.may_flip_within(spheres[sphere], trial.conventions().root, change);
  };
  if (choice.got == kSomeSphere) {
    // A false hit of whichever sphere.
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      if (class_may_flip(k)) return true;
    }
    return false;
  }
  if (choice.got && class_may_flip(*choice.got)) return true;
  if (!choice.exact) return false;
  if (class_may_flip(choice.exact->index)) return true;
  if (!choice.got || !trial.exact_hit(choice.ray, *choice.got)) return false;
  const auto widened = ray.enclose(256, change);
  return (widened.parameter(spheres[*choice.got],
                            trial.exact_intersection(choice.ray, *choice.got)) -
          widened.parameter(spheres[choice.exact->index], choice.exact->intersection))
      .contains_zero();
}

}  // namespace

Excuse excuse(Trial& trial, const Choice& choice, double change) {
  return may_flip(trial, choice, change) ? Excuse{ExcuseKind::kWitness, change} : Excuse{};
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
