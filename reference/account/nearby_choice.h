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

/// Whether a claim may be right at some point of its pixel's square: a ray of the neighbourhood
/// through a point of it may meet what is claimed. The square of pixel (i, j) is the i-th of w
/// columns and the j-th of h rows of the window, its sides included; so samples at edges, centres
/// and corners lie in it.
/// Shape:  a camera's ray, all spheres of its scene, a claim -> false only if it is proved.
/// Domain: that of right_nearby(). A given ray, and valid roots that are not all s >= 0: true.
/// Error:  true also if 1,024 parts of the square do not decide.
/// Source: interval arithmetic over parts of the square, each divided in four.
bool may_be_right_in_pixel(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                           const Neighbourhood& around, const FirstMet& claim);

}  // namespace raycheck::reference
