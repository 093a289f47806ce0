// The numbers of the filter of certified visibility: vectors of doubles and of double-doubles.
// Internal to reference/. Compiled once for each of Highway's targets, hence the guard.
//
// Every operation of double-doubles is within kDoubleDoubleError, 16 u^2, of its exact result
// unless something over- or underflows. Sums are AccurateDWPlusDW (3 u^2/(1 - 4 u)), and fused
// products are DWTimesDW3 (4 u^2), of M. Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error
// bounds for basic building blocks of double-word arithmetic, 2017. In products that are not fused,
// five roundings of numbers below u, 2u, 2u, 3u times |x y| add up to at most 8 u^2. Roots are
// SQRTDWtoDW (25/8 u^2) of V. Lefevre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau, Accurate
// calculation of Euclidean norms using double-word arithmetic, 2023.

#if defined(RAYCHECK_REFERENCE_VISIBILITY_LANES_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_REFERENCE_VISIBILITY_LANES_H_
#undef RAYCHECK_REFERENCE_VISIBILITY_LANES_H_
#else
#define RAYCHECK_REFERENCE_VISIBILITY_LANES_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raycheck::reference::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

struct Lanes {
  V high;
};
HWY_INLINE Lanes operator+(Lanes x, Lanes y) { return {hn::Add(x.high, y.high)}; }
HWY_INLINE Lanes operator-(Lanes x, Lanes y) { return {hn::Sub(x.high, y.high)}; }
HWY_INLINE Lanes operator*(Lanes x, Lanes y) { return {hn::Mul(x.high, y.high)}; }
HWY_INLINE Lanes mul_add(Lanes x, Lanes y, Lanes z) { return {hn::MulAdd(x.high, y.high, z.high)}; }
HWY_INLINE Lanes mul_sub(Lanes x, Lanes y, Lanes z) { return {hn::MulSub(x.high, y.high, z.high)}; }
HWY_INLINE Lanes sub_mul(Lanes x, Lanes y, Lanes z) {
  return {hn::NegMulAdd(x.high, y.high, z.high)};
}
/// x times a power of two, or 0.
HWY_INLINE Lanes scaled(Lanes x, V factor) { return {hn::Mul(x.high, factor)}; }
/// The square root in lanes that are `wanted`, 0 in the others.
HWY_INLINE Lanes root_where(M wanted, Lanes x) {
  return {hn::Sqrt(hn::IfThenElseZero(wanted, x.high))};
}
HWY_INLINE Lanes select(M condition, Lanes yes, Lanes no) {
  return {hn::IfThenElse(condition, yes.high, no.high)};
}

/// high + low, where `high` is the double nearest to the sum.
struct PairLanes {
  V high, low;
};

/// x + y exactly (Knuth).
HWY_INLINE PairLanes two_sum(V x, V y) {
  const V sum = hn::Add(x, y);
  const V of_y = hn::Sub(sum, x);
  return {sum, hn::Add(hn::Sub(x, hn::Sub(sum, of_y)), hn::Sub(y, of_y))};
}
/// x + y exactly, for |x| >= |y| (Dekker).
HWY_INLINE PairLanes ordered_sum(V x, V y) {
  const V sum = hn::Add(x, y);
  return {sum, hn::Sub(y, hn::Sub(sum, x))};
}

#if !HWY_NATIVE_FMA
/// x as the sum of two numbers of 26 bits (Veltkamp).
HWY_INLINE PairLanes halves(V x) {
  const V scaled = hn::Mul(x, hn::Set(D(), 0x1p27 + 1));
  const V high = hn::Sub(scaled, hn::Sub(scaled, x));
  return {high, hn::Sub(x, high)};
}
#endif

/// x y exactly, unless it underflows.
HWY_INLINE PairLanes two_product(V x, V y) {
  const V product = hn::Mul(x, y);
#if HWY_NATIVE_FMA
  return {product, hn::MulSub(x, y, product)};
#else
  const PairLanes a = halves(x), b = halves(y);
  const V high = hn::Sub(hn::Mul(a.high, b.high), product);
  const V middle = hn::Add(hn::Add(high, hn::Mul(a.high, b.low)), hn::Mul(a.low, b.high));
  return {product, hn::Add(middle, hn::Mul(a.low, b.low))};
#endif
}

HWY_INLINE PairLanes operator+(PairLanes x, PairLanes y) {
  const PairLanes high = two_sum(x.high, y.high), low = two_sum(x.low, y.low);
  const PairLanes sum = ordered_sum(high.high, hn::Add(high.low, low.high));
  return ordered_sum(sum.high, hn::Add(low.low, sum.low));
}
HWY_INLINE PairLanes operator-(PairLanes x, PairLanes y) {
  return x + PairLanes{hn::Neg(y.high), hn::Neg(y.low)};
}
HWY_INLINE PairLanes operator*(PairLanes x, PairLanes y) {
  const PairLanes product = two_product(x.high, y.high);
  const V lows = hn::MulAdd(x.high, y.low, hn::Mul(x.low, y.low));
  return ordered_sum(product.high, hn::Add(product.low, hn::MulAdd(x.low, y.high, lows)));
}
HWY_INLINE PairLanes mul_add(PairLanes x, PairLanes y, PairLanes z) { return x * y + z; }
HWY_INLINE PairLanes mul_sub(PairLanes x, PairLanes y, PairLanes z) { return x * y - z; }
HWY_INLINE PairLanes sub_mul(PairLanes x, PairLanes y, PairLanes z) { return z - x * y; }
HWY_INLINE PairLanes scaled(PairLanes x, V factor) {
  return {hn::Mul(x.high, factor), hn::Mul(x.low, factor)};
}
HWY_INLINE PairLanes root_where(M wanted, PairLanes x) {
  const V root = hn::Sqrt(hn::IfThenElse(wanted, x.high, hn::Set(D(), 1)));
  const PairLanes square = two_product(root, root);
  const V rest = hn::Add(hn::Sub(hn::Sub(x.high, square.high), square.low), x.low);
  const PairLanes both = ordered_sum(root, hn::Div(rest, hn::Add(root, root)));
  return {hn::IfThenElseZero(wanted, both.high), hn::IfThenElseZero(wanted, both.low)};
}
HWY_INLINE PairLanes select(M condition, PairLanes yes, PairLanes no) {
  return {hn::IfThenElse(condition, yes.high, no.high), hn::IfThenElse(condition, yes.low, no.low)};
}

}  // namespace raycheck::reference::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_REFERENCE_VISIBILITY_LANES_H_
