#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "properties/tally.h"
#include "properties/trial.h"

namespace raycheck::tools {

/// A hit that an interval of parameters, or culling, leaves out.
struct SwallowedHit {
  properties::Place place;
  double s = 0;         ///< Of the root that counts where every one >= 0 does; correctly rounded.
  double in_radii = 0;  ///< s over the sphere's radius, about; infinite where that is 0.
};

/// What becomes of the hits of a sphere.
struct SwallowedOfSphere {
  std::uint64_t hits = 0;       ///< Where every root >= 0 counts.
  std::uint64_t swallowed = 0;  ///< Of these, misses.
  std::uint64_t moved = 0;      ///< Hits still, but at the other root.
};

/// What an interval or culling costs: the exact hits of a scene without it, and with it.
struct Swallowed {
  std::vector<SwallowedOfSphere> spheres;
  std::vector<SwallowedHit> worst;  ///< Those farthest along their rays, in radii.

  SwallowedOfSphere all() const;
  void merge(const Swallowed& other);
};

/// So many of the worst are kept.
inline constexpr std::size_t kKeptSwallowed = 10;

/// Of the rays and the spheres of a trial, by the truth alone; nothing where every root >= 0
/// counts.
Swallowed swallowed(properties::Trial& trial);

}  // namespace raycheck::tools
