#pragma once

// Which of several spheres a ray meets first, by a candidate and exactly. Internal to the laws.

#include <cstddef>
#include <cstdint>
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

/// What excuses that a candidate's sphere is not the one that a ray meets first: inputs within a
/// relative change for which it is.
Excuse excuse(Trial& trial, std::size_t ray, Index got, double change);

/// What the rays of a case meet.
struct SpheresMet {
  std::vector<std::uint32_t> count;  ///< Spheres, by ray.
  std::vector<bool> is_unjudged;     ///< Rays that meet one in a tangent that is not judged.

  Expected expected(std::size_t ray) const {
    return count[ray] == 0   ? Expected::kNoSphere
           : count[ray] == 1 ? Expected::kOnlySphere
                             : Expected::kNearestOfSeveral;
  }
};
SpheresMet spheres_met(Trial& trial);

}  // namespace raycheck::properties
