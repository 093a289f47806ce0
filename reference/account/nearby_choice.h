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

/// Whether a claim is right for some ray and spheres of the neighbourhood: that the ray meets no
/// sphere, some sphere, or one given sphere before all others. The inputs of all spheres change
/// independently.
/// Shape:  a ray, all spheres of its scene, a claim -> a witness, a refutation, or neither.
/// Domain: that of ExactRay; an index outside the list of spheres throws std::invalid_argument.
/// Error:  that of right_nearby() for one sphere. A witness ends with the last input that changes.
///         Under Tangent::kEither no ray that touches a sphere is a witness.
/// Source: that of right_nearby() for one sphere. Intervals find the spheres that matter. That
///         several inequalities cannot all hold is shown by a sum of them (J. Farkas).
NearbyAnswer right_nearby(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                          const Neighbourhood& around, const FirstMet& claim);

}  // namespace raycheck::reference
