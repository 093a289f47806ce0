// The low part of `robust`'s residual. Internal to fast/. Compiled once for each of
// Highway's targets (fast/internal/lanes.h).

#if defined(RAYCHECK_FAST_INTERNAL_ROBUST_RESIDUAL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_ROBUST_RESIDUAL_H_
#undef RAYCHECK_FAST_INTERNAL_ROBUST_RESIDUAL_H_
#else
#define RAYCHECK_FAST_INTERNAL_ROBUST_RESIDUAL_H_
#endif

#include "fast/internal/triple.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

/// (2 w + v).v + the sum of square_rests - radius_rest. Each w_i^2, and r^2, is the sum of a coarse
/// part (coarse() in error_free.h), which is not used here, and a rest. Error: at most
/// kRobustLow u V r if, for each coordinate, |w_i| <= 1.01 r and |v_i| <= V, where V < 2^-17 r, and
/// each rest is at most 5.1u r^2 < 0.32 V r.
template <class N>
HWY_INLINE N low_of_residual(const Triple<N>& w, const Triple<N>& v, const Triple<N>& square_rests,
                             const N& radius_rest) {
  const auto coordinate = [](const N& wx, const N& vx, const N& rest) {
    return mul_add(mul_add(N(2), wx, vx), vx, rest);
  };
  return (coordinate(w.x, v.x, square_rests.x) + coordinate(w.y, v.y, square_rests.y)) +
         (coordinate(w.z, v.z, square_rests.z) - radius_rest);
}
inline constexpr double kRobustLow = 40;

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_FAST_INTERNAL_ROBUST_RESIDUAL_H_
