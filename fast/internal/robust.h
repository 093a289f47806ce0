#pragma once

// The three steps of the method `robust`: doubles, pairs of doubles, integers. The first two steps
// answer only if bounds on their errors prove the answer. Internal to fast/.
//
// All steps use T = C - o, f = |T|, a = |d|^2, b = T.d, c = f^2 - r^2, m = T x d and disc = b^2 - a
// c = a r^2 - |m|^2. If c < 0, the origin is inside, and 0 lies between the roots. If c > 0, both
// roots have the sign of b. The root that counts is |c|/q or q/a, where q = |b| + sqrt(disc) does
// not cancel. u = 2^-53. Bounds are to first order in u and leave at least 2% for the higher
// orders. ^ marks computed values.

#include <optional>

#include "fast/decide.h"
#include "fast/internal/batch_arrays.h"

namespace raycheck::fast {

/// The answer to one ray: `code` as decide() writes it; `at` is valid only for hits and tangents.
struct Decided {
  std::uint8_t code = kMiss;
  Hit at = {};

  std::optional<Hit> if_hit() const { return code != kMiss ? std::optional(at) : std::nullopt; }
};

/// A block of rays and spheres for the second step, scaled by powers of two where necessary, and
/// its answers. T = to_centre + rest; s and C - Q are pairs, too.
struct PairBlock {
  static constexpr std::size_t kSize = 64;
  double to_centre[3][kSize], rest[3][kSize], direction[3][kSize], radius[kSize];
  std::uint8_t code[kSize];                                    ///< kOpen: not proved.
  double s[kSize], s_rest[kSize], share[kSize], chord[kSize];  ///< As in PreciseHit.
  double from_point[3][kSize], from_rest[3][kSize];
  scene::Point3 centre[kSize];
  int length_exponent[kSize], exponent[kSize];  ///< Of C - Q and of s.

  /// Puts ray k; false if it can only be answered in integers.
  bool put(std::size_t k, const scene::Ray& ray, const scene::Sphere& sphere);
  /// Answers rays 0 to count - 1; s_rest, share and chord only if it is_precise.
  void answer(std::size_t count, scene::Root root, bool is_precise = false);
  /// The answer to ray k.
  Decided at(std::size_t k) const;
};

/// Answers the rays that the first step left open; invalid rays and spheres stay open. Codes are
/// those of decide() or, without roots, 1 and 0.
void settle(const BatchInput& input, const HitArrays& to, bool has_roots);

/// The answer in pairs of doubles, after scaling by powers of two; empty if it cannot be proved.
std::optional<Decided> answer_by_pairs(const scene::Ray& ray, const scene::Sphere& sphere,
                                       scene::Root root);

/// The answer in integers.
/// Domain: all doubles; invalid input (scene/validate.h) counts as a miss.
/// Error:  none in the class. s is rounded once, from a value with a relative error of at most
///         2^-120. Each coordinate of Q is rounded once, from a value that is off by at most 2^-120
///         of that of s d. If sqrt(disc) is an integer, s is correctly rounded.
Decided answer_by_integers(const scene::Ray& ray, const scene::Sphere& sphere, scene::HitRule rule);

}  // namespace raycheck::fast
