// Brings scene/lanes.h into the namespace of fast/'s formulas. Internal to fast/.

#if defined(RAYCHECK_FAST_INTERNAL_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_LANES_H_
#undef RAYCHECK_FAST_INTERNAL_LANES_H_
#else
#define RAYCHECK_FAST_INTERNAL_LANES_H_
#endif

#include "scene/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using scene::HWY_NAMESPACE::absolute;
using scene::HWY_NAMESPACE::all;
using scene::HWY_NAMESPACE::any;
using scene::HWY_NAMESPACE::bits;
using scene::HWY_NAMESPACE::DoubleTag;
using scene::HWY_NAMESPACE::kLaneCount;
using scene::HWY_NAMESPACE::LaneMask;
using scene::HWY_NAMESPACE::Lanes;
using scene::HWY_NAMESPACE::larger;
using scene::HWY_NAMESPACE::load;
using scene::HWY_NAMESPACE::MaskOf;
using scene::HWY_NAMESPACE::select;
using scene::HWY_NAMESPACE::smaller;
using scene::HWY_NAMESPACE::square_root;
using scene::HWY_NAMESPACE::store;

/// a b + c and a b - c, rounded once if the target has an instruction for it, else twice.
HWY_INLINE Lanes mul_add(Lanes a, Lanes b, Lanes c) {
  return Lanes(hn::MulAdd(a.raw, b.raw, c.raw));
}
HWY_INLINE Lanes mul_sub(Lanes a, Lanes b, Lanes c) {
  return Lanes(hn::MulSub(a.raw, b.raw, c.raw));
}
HWY_INLINE double mul_add(double a, double b, double c) {
  return HWY_NATIVE_FMA ? __builtin_fma(a, b, c) : a * b + c;
}
HWY_INLINE double mul_sub(double a, double b, double c) { return mul_add(a, b, -c); }
/// c - a b.
HWY_INLINE Lanes sub_mul(Lanes a, Lanes b, Lanes c) {
  return Lanes(hn::NegMulAdd(a.raw, b.raw, c.raw));
}
HWY_INLINE double sub_mul(double a, double b, double c) { return mul_add(-a, b, c); }

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_FAST_INTERNAL_LANES_H_
