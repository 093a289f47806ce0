// The first step of `robust`: hit or miss where doubles decide it, and the first root. Internal to
// fast/. Compiled once for each of Highway's targets (fast/internal/lanes.h).

#if defined(RAYCHECK_FAST_INTERNAL_ROBUST_GUESS_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_ROBUST_GUESS_H_
#undef RAYCHECK_FAST_INTERNAL_ROBUST_GUESS_H_
#else
#define RAYCHECK_FAST_INTERNAL_ROBUST_GUESS_H_
#endif

#include "fast/internal/intersect_batch.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

// A class is certain where |disc^| > kDiscriminantShare a r^2 + kFarShare a f^2 (kNearShare a f^2
// where disc = b^2 - a c), and f^2 differs from r^2 by more than kSurfaceShare r^2 + K M^2, M =
// |C|_1 + r, K = min(kReachShare + kSmallShare (M/r)^2, kMostReach); and where disc >
// kLeastDiscriminant and a + f^2, r^2 < kLargestSquare, so that no product overflows, a > 2^-600,
// for a hit r^2 > 2^-600, and anything that underflows is negligible beside the margins.
//
// Signs. |m^ - m| <= 4.3u f|d|, and |disc^ - disc| <= 19u a (f^2 + r^2) + u |disc^| by either
// formula, less than a hundredth of the margin; |c^ - c| <= 6u (f^2 + r^2). A miss by c and b
// requires no more of b: with c > 0 and disc > 0, b^2 > disc > kFarShare f^2 |d|^2 (0.99), while
// |b^ - b| <= 4u f|d|. (kRobustFar and its neighbours are machine-proved.)
// With disc < 0 the ray misses whatever b is. All of this holds whether or not products are fused
// with sums.

/// The margins required of disc and f^2 - r^2 in N's format. Certain signs require at most 32u of
/// each term (tests/fast/small_formats_test.cpp); a precise s in doubles requires these values.
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

// The bounds that proofs/ proves by machine for the coefficients below, in u: enough for all signs.
inline constexpr double kRobustB = 8;      ///< Of f |d|.
inline constexpr double kRobustC = 13;     ///< Of f^2 + r^2.
inline constexpr double kRobustNear = 38;  ///< Of a (f^2 + r^2), as the next.
inline constexpr double kRobustFar = 42;
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
    // With NaN comparisons fail: nothing is certain.
    const N known = select(square < N(Required::kLargestSquare), square, N(std::nan("")));
    inside = known - margin;
    outside = known + margin;
  }

  Triple<N> centre;
  N square;
  N doubt;
  N reach;            ///< M.
  N inside, outside;  ///< f^2 below/above: the origin is inside/outside.
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

/// The discriminant in two forms: the cheapest, and one without squares that cancel far away.
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

/// The first root.
template <class N>
struct First {
  N s0;
  N per_slope;  ///< 1 over the slope of |T - s d|^2 at the root.
};

/// The class where it is certain, and the root of a hit.
template <class N>
struct Guess {
  MaskOf<N> hit;
  MaskOf<N> certain;
  First<N> root;
};

/// Whether disc has a certain sign: kNearShare or kFarShare of a f^2 is required.
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
  // One division for two, beside the square root.
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
