// Doubles side by side, with the operators and functions of a single number, so that a formula is
// one template for every number type. Internal to fast/.
//
// Whatever is in HWY_NAMESPACE is compiled once for each of Highway's targets, hence the guard.
// Every operation rounds each lane once, as IEEE 754 has it: lanes agree with doubles to the bit.

#if defined(RAYCHECK_FAST_INTERNAL_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_LANES_H_
#undef RAYCHECK_FAST_INTERNAL_LANES_H_
#else
#define RAYCHECK_FAST_INTERNAL_LANES_H_
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::ScalableTag<double>;

/// The result of comparing lanes: one truth value per lane. Scalars use bool and its operators.
struct LaneMask {
  hn::Mask<DoubleTag> raw;
};
HWY_INLINE LaneMask operator&(LaneMask a, LaneMask b) { return {hn::And(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator|(LaneMask a, LaneMask b) { return {hn::Or(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator^(LaneMask a, LaneMask b) { return {hn::Xor(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator!(LaneMask a) { return {hn::Not(a.raw)}; }
HWY_INLINE bool any(LaneMask a) { return !hn::AllFalse(DoubleTag(), a.raw); }
HWY_INLINE bool any(bool a) { return a; }
HWY_INLINE bool all(LaneMask a) { return hn::AllTrue(DoubleTag(), a.raw); }

/// As many doubles as one register of the target holds.
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
HWY_INLINE LaneMask operator>=(Lanes a, Lanes b) { return {hn::Ge(a.raw, b.raw)}; }
HWY_INLINE LaneMask operator==(Lanes a, Lanes b) { return {hn::Eq(a.raw, b.raw)}; }

template <class N>
using MaskOf = decltype(std::declval<N>() < std::declval<N>());

/// Specialised for number types whose square root is neither in std:: nor in their namespace.
template <class N>
N square_root(const N& x) {
  using std::sqrt;
  return sqrt(x);
}
HWY_INLINE Lanes square_root(Lanes x) { return Lanes(hn::Sqrt(x.raw)); }

HWY_INLINE double absolute(double x) { return std::abs(x); }
HWY_INLINE Lanes absolute(Lanes x) { return Lanes(hn::Abs(x.raw)); }

HWY_INLINE double smaller(double x, double y) { return x < y ? x : y; }
HWY_INLINE Lanes smaller(Lanes x, Lanes y) { return Lanes(hn::Min(x.raw, y.raw)); }
HWY_INLINE double larger(double x, double y) { return x > y ? x : y; }
HWY_INLINE Lanes larger(Lanes x, Lanes y) { return Lanes(hn::Max(x.raw, y.raw)); }

/// `yes` where the condition holds, else `no`.
template <class N>
HWY_INLINE N select(bool condition, const N& yes, const N& no) {
  return condition ? yes : no;
}
HWY_INLINE Lanes select(LaneMask condition, Lanes yes, Lanes no) {
  return Lanes(hn::IfThenElse(condition.raw, yes.raw, no.raw));
}

inline constexpr std::size_t kLaneCount = hn::MaxLanes(DoubleTag());

HWY_INLINE Lanes load(const double* from) { return Lanes(hn::LoadU(DoubleTag(), from)); }
HWY_INLINE void store(Lanes x, double* to) { hn::StoreU(x.raw, DoubleTag(), to); }
/// One bit per lane, lowest lane first.
HWY_INLINE std::uint8_t bits(LaneMask mask) {
  std::uint8_t result = 0;
  hn::StoreMaskBits(DoubleTag(), mask.raw, &result);
  return result;
}

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_FAST_INTERNAL_LANES_H_
