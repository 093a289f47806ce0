#pragma once

#include <optional>
#include <vector>

#include "reference/enclosure.h"
#include "reference/exact_ray.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::reference {

/// Every input x becomes x (1 + its share), exactly. The inputs are those of the ray (eye, look-at,
/// up, near, left, right, bottom, top of a camera; origin and direction of a given ray), then the
/// centre and the radius of each sphere.
using InputChange = std::vector<double>;

/// Whether a wrong answer is right for inputs close by.
enum class Nearby { kWitness, kRefuted, kUndecided };

struct NearbyAnswer {
  Nearby found = Nearby::kUndecided;
  InputChange witness;  ///< Only for kWitness: inputs for which the answer is right.
};

/// A question about inputs close by: under which conventions, and how close.
struct Neighbourhood {
  scene::Root root = scene::Root::kNearest;
  scene::Tangent tangent = scene::Tangent::kHit;
  double relative_change = 0;    ///< Of each input, at most.
  scene::ValidRoots valid = {};  ///< Which roots count: not inputs; taken exactly.
};

/// Whether a ray and a sphere of the neighbourhood meet as an answer says: not at all (empty), or
/// at s, the root s' that the conventions ask for. s itself may be off, but not negative: by the
/// same share of s and of the distance from the origin to the centre (its largest coordinate over
/// the direction's); or, near a double root, as far as a (|s - s'| + |s' - s''|)^2 <= R, where a =
/// |g|^2, s'' is the other root, and R is the change of |T - s g|^2 - r^2 over the neighbourhood,
/// to first order.
/// Shape:  a ray, a sphere and an answer -> a witness, a refutation, or neither.
/// Units:  s in multiples of a given ray's direction, as a length of a camera's.
/// Domain: as ExactRay; an s that is negative or NaN is refuted.
/// Error:  witnesses are verified and refutations proven, both by balls, or by intervals where an
///         answer is far from right. Both are searched for where the deciders are linear in the
///         inputs, as they nearly are over a small neighbourhood; over wide ones by lengths of
///         vectors, witnesses also by projections and along lines. The rest is undecided: roots
///         about as far from right as the neighbourhood is wide, and answers that only an exact
///         tangent would make right. Where not every root >= 0 counts, see
///         reference/account/nearby_valid.h.
/// Source: mixed forward-backward error (N. J. Higham, Accuracy and Stability of Numerical
///         Algorithms, 1.5); mean-value forms (R. E. Moore, Interval Analysis); linear programs of
///         one equation over a box, by the breakpoints of their dual (G. B. Dantzig's fractional
///         knapsack).
NearbyAnswer right_nearby(const ExactRay& ray, const scene::Sphere& sphere,
                          const Neighbourhood& around, const std::optional<double>& answer);

}  // namespace raycheck::reference
