// Vectors of doubles with the operators and functions of a single number, so that a formula is one
// template for every number type.
//
// The code in HWY_NAMESPACE is compiled once for each of Highway's targets, hence the guard.
// Every operation rounds each lane once, as IEEE-754 says: lanes agree with doubles to the bit.

#if defined(RAYCHECK_SCENE_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_SCENE_LANES_H_
#undef RAYCHECK_SCENE_LANES_H_
#else
#define RAYCHECK_SCENE_LANES_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "scene/numbers.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using scene::absolute;
using scene::larger;
using scene::MaskOf;
using scene::rounded_down;
using scene::rounded_up;
using scene::select;
using scene::smaller;
using scene::square_root;

using DoubleTag = hn::ScalableTag<double>;

/// The result of comparing lanes: one truth value per lane. For single numbers it is bool.
struct LaneMask {
  hn::Mask<DoubleTag> raw;
};
HWY_INLINE LaneMask operator&(LaneMask a, LaneMask b) { return {hn::And(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator|(LaneMask a, LaneMask b) { return {hn::Or(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator^(LaneMask a, LaneMask b) { return {hn::Xor(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator!(LaneMask a) { return {hn::Not(a.raw)}; }
HWY_INLINE bool any(LaneMask a) { return !hn::AllFalse(DoubleTag(), a.raw); }
HWY_INLINE bool any(bool a) { return a; }
HWY_INLINE bool all(bool a) { return a; }
HWY_INLINE bool all(LaneMask a) { return hn::AllTrue(DoubleTag(), a.raw); }

/// The doubles in one register of the target.
struct Lanes {
  hn::Vec<DoubleTag> raw;

  Lanes() = default;
  explicit Lanes(hn::Vec<DoubleTag> from) : raw(from) {}
  explicit Lanes(double x) : raw(hn::Set(DoubleTag(), x)) {}
};
HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return Lanes(hn::Add(a.raw, b.raw)); }
HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return Lanes(hn::Sub(a.raw, b.raw)); }
HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return Lanes(hn::Mul(a.raw, b.raw)); }
HWY_INLINE Lanes operator/(Lanes a, Lanes b) { return Lanes(hn::Div(a.raw, b.raw)); }
HWY_INLINE Lanes operator-(Lanes a) { return Lanes(hn::Neg(a.raw)); }
HWY_INLINE LaneMask operator<(Lanes a, Lanes b) { return {hn::Lt(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator>(Lanes a, Lanes b) { return {hn::Gt(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator<=(Lanes a, Lanes b) { return {hn::Le(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator>=(Lanes a, Lanes b) { return {hn::Ge(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator==(Lanes a, Lanes b) { return {hn::Eq(a.raw, b.raw)}; }

HWY_INLINE Lanes square_root(Lanes x) { return Lanes(hn::Sqrt(x.raw)); }

HWY_INLINE Lanes absolute(Lanes x) { return Lanes(hn::Abs(x.raw)); }

HWY_INLINE Lanes smaller(Lanes x, Lanes y) { return Lanes(hn::Min(x.raw, y.raw)); }
HWY_INLINE Lanes larger(Lanes x, Lanes y) { return Lanes(hn::Max(x.raw, y.raw)); }

HWY_INLINE Lanes rounded_up(Lanes x) { return Lanes(hn::Ceil(x.raw)); }
HWY_INLINE Lanes rounded_down(Lanes x) { return Lanes(hn::Floor(x.raw)); }

HWY_INLINE Lanes select(LaneMask condition, Lanes yes, Lanes no) {
  return Lanes(hn::IfThenElse(condition.raw, yes.raw, no.raw));
}

inline constexpr std::size_t kLaneCount = hn::MaxLanes(DoubleTag());

HWY_INLINE Lanes load(const double* from) { return Lanes(hn::LoadU(DoubleTag(), from)); }
/// Loads kLaneCount groups of four doubles: a gets the first of each group, b the second, and so
/// on.
HWY_INLINE void load_fours(const double* from, Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
  hn::LoadInterleaved4(DoubleTag(), from, a.raw, b.raw, c.raw, d.raw);
}
HWY_INLINE void store(double x, double* to) { *to = x; }
HWY_INLINE void store(Lanes x, double* to) { hn::StoreU(x.raw, DoubleTag(), to); }
HWY_INLINE std::uint8_t bits(bool one) { return one ? 1 : 0; }
/// One bit per lane, lowest lane first.
HWY_INLINE std::uint8_t bits(LaneMask mask) {
  std::uint8_t result = 0;
  hn::StoreMaskBits(DoubleTag(), mask.raw, &result);
  return result;
}

}  // namespace raycheck::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_SCENE_LANES_H_
