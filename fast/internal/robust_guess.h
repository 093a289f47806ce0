// The first step of `robust`: hit or miss, if doubles decide it, and a first value of the root.
// Internal to fast/. Compiled once for each of Highway's targets (fast/internal/lanes.h).

#if defined(RAYCHECK_FAST_INTERNAL_ROBUST_GUESS_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_ROBUST_GUESS_H_
#undef RAYCHECK_FAST_INTERNAL_ROBUST_GUESS_H_
#else
#define RAYCHECK_FAST_INTERNAL_ROBUST_GUESS_H_
#endif

#include "fast/internal/intersect_batch.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

// A class is certain if three conditions hold.
//   |disc^| > kDiscriminantShare a r^2 + kFarShare a f^2. If disc was computed as b^2 - a c,
//   kNearShare takes the place of kFarShare.
//   |f^2 - r^2| > kSurfaceShare r^2 + K M^2, where M = |C|_1 + r and
//   K = min(kReachShare + kSmallShare (M/r)^2, kMostReach).
//   |disc^| > kLeastDiscriminant, a + f^2 < kLargestSquare and r^2 < kLargestSquare.
// By the third, no product overflows, a > 2^-600, for a hit r^2 > 2^-600, and underflows are
// negligible beside the margins.
//
// Signs. |m^ - m| <= 4.3u f|d|, |c^ - c| <= 6u (f^2 + r^2), and by either formula |disc^ - disc| <=
// 19u a (f^2 + r^2) + u |disc^|, less than a hundredth of the margin. A miss that follows from the
// signs of c and b requires no margin for b: if c > 0 and disc > 0, then b^2 > disc > kFarShare f^2
// |d|^2 (0.99), while |b^ - b| <= 4u f|d|. If disc < 0, the ray misses for every b. All of this
// holds whether or not products are fused with sums. (Machine proofs of such bounds: kRobustB to
// kRobustFar.)

/// The margins required of disc and f^2 - r^2 in N's format. Certain signs require only 32u of each
/// term (tests/fast/small_formats_test.cpp); a precise s in doubles requires these values.
template <class N>
struct Margins {
  static constexpr double kDiscriminantShare = 0x1p-13;
  static constexpr double kNearShare = 0x1p-28;
  static constexpr double kFarShare = 0x1p-31;
  static constexpr double kSurfaceShare = 0x1p-26;
  static constexpr double kReachShare = 0x1p-32;
  static constexpr double kSmallShare = 0x1p-66;
  static constexpr double kMostReach = 0x1p-24;
  static constexpr double kLeastDiscriminant = 0x1p-300;
  static constexpr double kLargestSquare = 0x1p300;
};

// Machine-proved bounds (proofs/) on the errors of the coefficients below, small enough for all
// signs.
inline constexpr double kRobustB = 8;      ///< b: in u of f |d|.
inline constexpr double kRobustC = 13;     ///< c: in u of f^2 + r^2.
inline constexpr double kRobustNear = 38;  ///< near_discriminant(): in u of a (f^2 + r^2).
inline constexpr double kRobustFar = 42;   ///< far_discriminant(): in u of a (f^2 + r^2).
static_assert(Margins<double>::kNearShare > 100 * kRobustNear * 0x1p-53 &&
              Margins<double>::kFarShare > 100 * kRobustFar * 0x1p-53 &&
              Margins<double>::kFarShare < Margins<double>::kNearShare &&
              Margins<double>::kFarShare < Margins<double>::kDiscriminantShare &&
              Margins<double>::kReachShare > 100 * kRobustC * 0x1p-53 &&
              Margins<double>::kFarShare / 2 > kRobustB * kRobustB * 0x1p-106);

/// The terms that depend only on the sphere.
template <class N>
struct Ball {
  using Required = Margins<N>;

  HWY_INLINE explicit Ball(const SphereOf<N>& sphere)
      : centre(sphere.centre),
        square(sphere.radius * sphere.radius),
        doubt(N(Required::kDiscriminantShare) * square),
        reach(absolute(centre.x) + absolute(centre.y) + absolute(centre.z) + sphere.radius) {
    const N ratio = reach / sphere.radius;
    const N share = smaller(N(Required::kReachShare) + N(Required::kSmallShare) * (ratio * ratio),
                            N(Required::kMostReach));
    const N margin = N(Required::kSurfaceShare) * square + share * (reach * reach);
    // Comparisons with NaN fail, so that nothing is certain.
    const N known = select(square < N(Required::kLargestSquare), square, N(std::nan("")));
    inside = known - margin;
    outside = known + margin;
  }

  Triple<N> centre;
  N square;
  N doubt;
  N reach;            ///< M.
  N inside, outside;  ///< If f^2 < inside, the origin is inside; if f^2 > outside, it is outside.
};

/// The terms that decide the hit class.
template <class N>
struct Coefficients {
  N a, b, distance_sq, c;
};
template <class N>
HWY_INLINE Coefficients<N> coefficients(const Triple<N>& T, const Triple<N>& direction,
                                        const N& radius_sq) {
  const N distance_sq = fused_dot(T, T);
  return {fused_dot(direction, direction), fused_dot(T, direction), distance_sq,
          distance_sq - radius_sq};
}

/// The discriminant in two forms: b^2 - a c, which is cheap, and a r^2 - |m|^2, whose terms do not
/// cancel for far spheres.
template <class N>
HWY_INLINE N near_discriminant(const N& a, const N& b, const N& c) {
  return mul_sub(b, b, a * c);
}
template <class N>
HWY_INLINE N far_discriminant(const Triple<N>& T, const Triple<N>& direction, const N& a,
                              const N& radius_sq) {
  const Triple<N> moment = cross(T, direction);
  return mul_sub(a, radius_sq, fused_dot(moment, moment));
}

/// A first value of the root.
template <class N>
struct First {
  N s0;
  N per_slope;  ///< 1 over the slope of |T - s d|^2 at the root.
};

/// The class, valid only if it is certain, and the root of a hit.
template <class N>
struct Guess {
  MaskOf<N> hit;
  MaskOf<N> certain;
  First<N> root;
};

/// Whether the sign of disc is certain. `share` is kNearShare or kFarShare.
template <class N>
HWY_INLINE MaskOf<N> has_sign(N discriminant, N a, N distance_sq, const Ball<N>& ball,
                              double share) {
  return absolute(discriminant) >
         larger(a * mul_add(N(share), distance_sq, ball.doubt), N(Margins<N>::kLeastDiscriminant));
}

template <class N>
HWY_INLINE Guess<N> guess(const RayOf<N>& ray, const Ball<N>& ball, scene::Root root) {
  using Required = Margins<N>;
  const Triple<N> T = ball.centre - ray.origin;
  const auto [a, b, distance_sq, c] = coefficients(T, ray.direction, ball.square);
  N discriminant = near_discriminant(a, b, c);
  MaskOf<N> decided = has_sign(discriminant, a, distance_sq, ball, Required::kNearShare);
  if (!all(decided)) {
    discriminant =
        select(decided, discriminant, far_discriminant(T, ray.direction, a, ball.square));
    decided = has_sign(discriminant, a, distance_sq, ball, Required::kFarShare);
  }
  const auto outside = distance_sq > ball.outside;
  const auto behind = b < N(0);
  const MaskOf<N> certain = decided & (a + distance_sq < N(Required::kLargestSquare)) &
                            (outside | (distance_sq < ball.inside));
  const MaskOf<N> no_root = root == scene::Root::kNearest ? outside & behind : (!outside) | behind;
  const MaskOf<N> hit = certain & (discriminant > N(0)) & !no_root;
  if (!any(hit)) return {hit, certain, {}};
  // One division gives both quotients, and runs in parallel with the square root.
  const N inverse = N(1) / (a * discriminant);
  const N root_of = square_root(discriminant);
  const N half_slope = select(outside, -root_of, root_of);
  return {hit,
          certain,
          {(b + half_slope) * (discriminant * inverse), (N(0.5) * half_slope) * (a * inverse)}};
}

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_FAST_INTERNAL_ROBUST_GUESS_H_
