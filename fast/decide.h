#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "fast/internal/batch_arrays.h"

namespace raycheck::fast {

// What decide() writes for a ray: kMiss, kOpen, or kHit, perhaps with flags.
inline constexpr std::uint8_t kMiss = 0, kHit = 1;
/// The larger root is the one that counts.
inline constexpr std::uint8_t kLargerRoot = 4;
/// A double root.
inline constexpr std::uint8_t kTangentRay = 8;

/// The classes, roots, s and Q of rays by the method `robust`.
/// Shape:  N rays; one sphere, or N -> N answers.
/// Domain: all doubles. Invalid rays and spheres (scene/validate.h) have the code kOpen, and no
///         other answer depends on them.
/// Error:  classes and roots are exact; s and Q are off by at most kDecidedS and kDecidedPoint
///         (bound_errors()). s and Q of misses are NaN.
void decide(const BatchInput& input, const HitArrays& answers);

/// s and C - Q of a hit to about 100 bits.
struct PreciseHit {
  double s, rest;  ///< |s + rest - the exact s| <= share |s|.
  double share;    ///< Infinite if this is not known.
  double chord;    ///< About the distance of the roots.
  /// Each coordinate of from + from_rest is off from C - Q by at most (share + kPreciseStep) |s
  /// d_k|
  /// + kPreciseStep |T_k|.
  scene::Point3 T, from, from_rest;
};
inline constexpr double kPreciseStep = 0x1p-98;
/// The hits of some of the rays, by the second step of `robust`.
void precise_hits(const BatchInput& input, std::span<const std::uint32_t> rays, PreciseHit* hits);

/// |s^ - s| <= kDecidedS |s^| + the least double. Before it is rounded, s is off by 2^-56.1 of
/// itself after the first step (fast/methods/intersect_robust.cpp), by 0.1 ulp in pairs, and by
/// 2^-120 in integers; rounding adds at most u |s^|, or half of the least double.
inline constexpr double kDecidedS = 1.12 * 0x1p-53;
/// |Q^_k - Q_k| <= kDecidedPoint |Q^_k| + kDecidedStep |s^ d_k| + kDecidedReach (M + |L|_1) + the
/// least double, where M = |C|_1 + r. The terms are the rounding of Q; the error of s before it is
/// rounded; and, in the first step, the roundings of v and of the correction: |s0 - s| |d| <=
/// 2^-34.5 (f + r), so that two roundings of it, of v, which is at most u(16M + 3f), and v's own
/// error, 2.7u of that, are together below 2^-86 (f + M), and f <= |L|_1 + M. Pairs are off by
/// less: by 2^-99 of |T_k| and |s d_k|.
inline constexpr double kDecidedPoint = 0x1p-53 * (1 + 0x1p-50);
inline constexpr double kDecidedStep = 0x1p-56;
inline constexpr double kDecidedReach = 0x1p-85;

inline constexpr double kLeastDouble = 0x1p-1074;

/// These bounds for the answers of decide(); null arrays are left out. A bound is infinite if s or
/// Q is, and NaN for a miss.
void bound_errors(const BatchInput& input, const HitArrays& answers, double* s_error,
                  double* const (&point_error)[3]);

}  // namespace raycheck::fast
