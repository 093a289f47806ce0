// Intervals that contain every result of a formula, in its own floating-point arithmetic, for a box
// of inputs. Internal to fast/. Compiled once for each of Highway's targets
// (fast/internal/lanes.h).

#if defined(RAYCHECK_FAST_INTERNAL_BETWEEN_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_BETWEEN_H_
#undef RAYCHECK_FAST_INTERNAL_BETWEEN_H_
#else
#define RAYCHECK_FAST_INTERNAL_BETWEEN_H_
#endif

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "fast/internal/triple.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

/// The result of comparing Betweens.
struct Possible {
  bool can_be_true, can_be_false;
};
inline Possible operator&(Possible a, Possible b) {
  return {a.can_be_true && b.can_be_true, a.can_be_false || b.can_be_false};
}

/// The least and the greatest result that F's arithmetic can have if each operand lies between two
/// numbers. Rounding to nearest is monotone, and so is each operation if its operands keep their
/// signs; therefore both results are among those at the ends. If a result at the ends is not
/// finite, any result is possible, also NaN; least and greatest are then NaN.
template <class F>
struct Between {
  F least, greatest;
  explicit Between(double x) : Between(x, x) {}
  Between(double from, double to) : least(static_cast<F>(from)), greatest(static_cast<F>(to)) {}
  Between(std::initializer_list<F> results) : Between(std::numeric_limits<double>::quiet_NaN()) {
    for (const F result : results) {
      if (!std::isfinite(result)) return;
    }
    least = std::min(results);
    greatest = std::max(results);
  }
};

template <class F>
Between<F> operator-(const Between<F>& a) {
  return std::initializer_list<F>{-a.greatest, -a.least};
}
template <class F>
Between<F> operator+(const Between<F>& a, const Between<F>& b) {
  return std::initializer_list<F>{a.least + b.least, a.greatest + b.greatest};
}
template <class F>
Between<F> operator-(const Between<F>& a, const Between<F>& b) {
  return a + -b;
}
/// Squares have tighter bounds than products of independent numbers.
template <class F>
Between<F> operator*(const Between<F>& a, const Between<F>& b) {
  const F low = a.least * b.least, high = a.greatest * b.greatest;
  if (&a == &b) return std::initializer_list<F>{low, high, a.least * a.greatest < 0 ? F(0) : low};
  return std::initializer_list<F>{low, high, a.least * b.greatest, a.greatest * b.least};
}
template <class F>
Between<F> operator/(const Between<F>& a, const Between<F>& b) {
  if (!(b.least > 0 || b.greatest < 0)) return Between<F>(std::numeric_limits<F>::quiet_NaN());
  return std::initializer_list<F>{a.least / b.least, a.greatest / b.greatest, a.least / b.greatest,
                                  a.greatest / b.least};
}
template <class F>
Between<F> sqrt(const Between<F>& a) {
  return std::initializer_list<F>{std::sqrt(a.least), std::sqrt(a.greatest)};
}

template <class F>
Possible operator<(const Between<F>& a, const Between<F>& b) {
  return {!(a.least >= b.greatest), !(a.greatest < b.least)};
}
template <class F>
Possible operator>(const Between<F>& a, const Between<F>& b) {
  return b < a;
}
template <class F>
Possible operator>=(const Between<F>& a, const Between<F>& b) {
  return {!(a.greatest < b.least), !(a.least >= b.greatest)};
}
template <class F>
Possible operator==(const Between<F>& a, const Between<F>& b) {
  return (a >= b) & (b >= a);
}

template <class F>
Between<F> select(Possible condition, const Between<F>& yes, const Between<F>& no) {
  if (!condition.can_be_false) return yes;
  if (!condition.can_be_true) return no;
  return std::initializer_list<F>{yes.least, yes.greatest, no.least, no.greatest};
}

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_FAST_INTERNAL_BETWEEN_H_
