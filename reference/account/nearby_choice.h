#pragma once

#include <cstddef>
#include <span>

#include "reference/account/nearby_answer.h"

namespace raycheck::reference {

/// A claim about what a ray meets first.
struct FirstMet {
  enum class What {
    kNothing,
    kSomething,  ///< A sphere, whichever.
    kSphere,
  };
  What what = What::kNothing;
  std::size_t sphere = 0;  ///< For kSphere only: its index.
};

/// Whether a ray of the neighbourhood meets first what it is said to: no sphere; some sphere; or
/// one sphere, and none of the others before it. The inputs of all spheres change independently.
/// Shape:  a ray, all spheres of its scene, a claim -> a witness, a refutation, or neither.
/// Domain: as ExactRay; an index of no sphere throws std::invalid_argument.
/// Error:  as the other right_nearby. A witness ends with the last input that changes; inputs
/// beyond
///         it are as they were. Under Tangent::kEither no ray that touches a sphere is a witness.
/// Source: as the other right_nearby; intervals find the spheres that matter. Which of several
///         inequalities cannot be so at once is shown by a sum of them (J. Farkas).
NearbyAnswer right_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                          const Neighbourhood& around, const FirstMet& claim);

}  // namespace raycheck::reference
