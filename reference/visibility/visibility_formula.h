// The formulas of the filter of certified visibility, for all number types that have mul_add(x, y,
// z) = x y + z, mul_sub(x, y, z) = x y - z and sub_mul(x, y, z) = z - x y, each rounded once. These
// are vectors of doubles, and the recording numbers of proofs/. visibility_kernel.h explains the
// names and the bound. Internal to reference/. Compiled once for each of Highway's targets, hence
// the guard.

#if defined(RAYCHECK_REFERENCE_VISIBILITY_FORMULA_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_REFERENCE_VISIBILITY_FORMULA_H_
#undef RAYCHECK_REFERENCE_VISIBILITY_FORMULA_H_
#else
#define RAYCHECK_REFERENCE_VISIBILITY_FORMULA_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raycheck::reference::HWY_NAMESPACE {

/// The terms that the pixels of a row share.
template <class N>
struct RowTerms {
  N b;       ///< n w + beta v
  N a;       ///< n^2 + beta^2
  N moment;  ///< n v - beta w, the first component of f x g
  N n_u, beta_u;
};

template <class N>
HWY_INLINE RowTerms<N> row_terms(const N& near, const N& beta, const N& u, const N& v, const N& w) {
  return {near * w + beta * v, near * near + beta * beta, near * v - beta * w, near * u, beta * u};
}

/// b = f.g and a = |g|^2
template <class N>
HWY_INLINE N b_of(const N& alpha, const N& u, const N& row_b) {
  return mul_add(alpha, u, row_b);
}
template <class N>
HWY_INLINE N a_of(const N& alpha, const N& row_a) {
  return mul_add(alpha, alpha, row_a);
}

/// b^2 - c a
template <class N>
HWY_INLINE N discriminant(const N& b, const N& a, const N& power) {
  return mul_sub(b, b, power * a);
}

/// f x g
template <class N>
struct Moment {
  N first, second, third;
};
template <class N>
HWY_INLINE Moment<N> moment_of(const N& alpha, const N& v, const N& w, const RowTerms<N>& row) {
  return {row.moment, mul_sub(alpha, w, row.n_u), sub_mul(alpha, v, row.beta_u)};
}

/// r^2 a - |f x g|^2, which is equal to b^2 - c a. If r is much smaller than |f|, its terms do not
/// cancel.
template <class N>
HWY_INLINE N discriminant_by_moment(const Moment<N>& moment, const N& a, const N& radius_sq) {
  const N two = mul_add(moment.second, moment.second, moment.first * moment.first);
  return mul_sub(radius_sq, a, mul_add(moment.third, moment.third, two));
}

}  // namespace raycheck::reference::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_REFERENCE_VISIBILITY_FORMULA_H_
