#pragma once

#include <optional>
#include <vector>

#include "reference/enclosure.h"
#include "reference/exact_ray.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::reference {

/// The shares by which inputs change: an input x becomes x (1 + share), exactly. The inputs are
/// those of the ray (eye, look-at, up, near, left, right, bottom, top of a camera; origin and
/// direction of a given ray), then the centre and the radius of each sphere.
using InputChange = std::vector<double>;

/// Whether a wrong answer is right for inputs close by.
enum class Nearby { kWitness, kRefuted, kUndecided };

struct NearbyAnswer {
  Nearby found = Nearby::kUndecided;
  InputChange witness;  ///< For kWitness: a change of the inputs that makes the answer right.
};

/// The inputs close by, and the conventions for them.
struct Neighbourhood {
  scene::Root root = scene::Root::kNearest;
  scene::Tangent tangent = scene::Tangent::kHit;
  double relative_change = 0;    ///< The largest relative change of each input.
  scene::ValidRoots valid = {};  ///< The roots that count. They are exact and do not change.
};

/// Whether an answer is right for a ray and a sphere of the neighbourhood. The answer is that they
/// do not meet (empty), or that they meet at s. Let s' be the root that the conventions ask for,
/// s'' the other root. s must not be negative, and may be off from s' by the relative change times
/// s plus the distance from the origin to the centre (its largest coordinate over the direction's).
/// Near a double root it may also be off as far as a (|s - s'| + |s' - s''|)^2 <= R, where a =
/// |g|^2, and R is the change of |T - s g|^2 - r^2 over the neighbourhood, to first order.
/// Shape:  a ray, a sphere and an answer -> a witness, a refutation, or neither.
/// Units:  s in multiples of a given ray's direction; for a camera's ray, a length.
/// Domain: that of ExactRay. An s that is negative or NaN is refuted.
/// Error:  witnesses are verified and refutations proved, both by balls, or by intervals if an
///         answer is far from right. The search assumes that the deciders are linear in the inputs,
///         as they nearly are over a small neighbourhood. In wide neighbourhoods it uses lengths of
///         vectors, and for witnesses also projections and lines. Undecided are roots that are
///         about as far from right as the neighbourhood is wide, and answers that only an exact
///         tangent would make right. If not every root >= 0 counts, see
///         reference/account/nearby_valid.h.
/// Source: mixed forward-backward error (N. J. Higham, Accuracy and Stability of Numerical
///         Algorithms, 1.5); mean-value forms (R. E. Moore, Interval Analysis); linear programs of
///         one equation over a box, by the breakpoints of their dual (G. B. Dantzig's fractional
///         knapsack).
NearbyAnswer right_nearby(const ExactRay& ray, const scene::Sphere& sphere,
                          const Neighbourhood& around, const std::optional<double>& answer);

}  // namespace raycheck::reference
