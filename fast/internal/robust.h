#pragma once

// The three steps of the method `robust`: doubles, pairs of doubles, integers. The first two answer
// only where bounds on their own errors prove the answer. Internal to fast/.
//
// What all steps share: T = C - o, f = |T|, a = |d|^2, b = T.d, c = f^2 - r^2, m = T x d and disc =
// b^2 - a c = a r^2 - |m|^2. With c < 0 the origin is inside, between the roots. With c > 0 both
// roots have b's sign. The root that counts is |c|/q or q/a, where q = |b| + sqrt(disc) does not
// cancel. u = 2^-53; bounds are to first order in u, with at least 2% of room for the rest; ^ marks
// computed values.

#include <optional>

#include "fast/internal/batch_arrays.h"

namespace raycheck::fast {

/// An answer in pairs of doubles, after scaling by powers of two; empty where it cannot prove one.
std::optional<Chosen> answer_by_pairs(const scene::Ray& ray, const scene::Sphere& sphere,
                                      scene::Root root);

/// The answer in integers.
/// Domain: all doubles; invalid input (scene/validate.h) counts as a miss.
/// Error:  none in the class. s and the coordinates of Q are rounded once, from values off by at
///         most 2^-120 of s and of s d; s is correctly rounded where sqrt(disc) is an integer.
Chosen answer_by_integers(const scene::Ray& ray, const scene::Sphere& sphere, scene::HitRule rule);

}  // namespace raycheck::fast
