#ifndef RAYCHECK_PROPERTIES_SPHERE_CHOICE_H_
#define RAYCHECK_PROPERTIES_SPHERE_CHOICE_H_

// Which of several spheres a ray meets first, by a candidate and exactly. Internal to the laws.

#include <cstddef>
#include <optional>
#include <vector>

#include "properties/trial.h"

namespace raycheck::properties {

using Index = std::optional<std::size_t>;

/// The candidate's sphere (or kSomeSphere) and the exact one, both by the scene's order.
struct Choice {
  std::size_t ray;
  Index got;
  const std::optional<reference::NearestSphere>& exact;
};

bool is_right(const Choice& choice);
Wrong wrong_of(const Choice& choice);

/// Whether a relative change of the inputs by so much may flip the class of one of the two spheres,
/// or their order.
bool may_flip(Trial& trial, const Choice& choice, double change);

/// The rays that meet a sphere in a tangent that is not judged.
std::vector<bool> with_unjudged(Trial& trial);

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_SPHERE_CHOICE_H_
