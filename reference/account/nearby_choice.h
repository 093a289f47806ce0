#pragma once

#include <cstddef>
#include <span>

#include "reference/account/nearby_answer.h"

namespace raycheck::reference {

/// A claim about the first hit of a ray.
struct FirstMet {
  enum class What {
    kNothing,
    kSomething,  ///< Any sphere.
    kSphere,
  };
  What what = What::kNothing;
  std::size_t sphere = 0;  ///< For kSphere only: its index.
};

/// Whether a ray of the neighbourhood meets first what is claimed: no sphere, any sphere, or one
/// sphere before all others. The inputs of all spheres change independently.
/// Shape:  a ray, all spheres of its scene, a claim -> a witness, a refutation, or neither.
/// Domain: as ExactRay; an index outside the list of spheres throws std::invalid_argument.
/// Error:  as the other right_nearby. A witness ends with the last input that changes; later inputs
///         are unchanged. Under Tangent::kEither no ray that touches a sphere is a witness.
/// Source: as the other right_nearby; intervals find the spheres that matter. Which of several
///         inequalities cannot be so at once is shown by a sum of them (J. Farkas).
NearbyAnswer right_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                          const Neighbourhood& around, const FirstMet& claim);

}  // namespace raycheck::reference
