#pragma once

// Numbers of about 106 bits as unevaluated sums of two doubles. Internal to fast/. Source of the
// algorithms and their names: Joldes, Muller and Popescu, Tight and rigorous error bounds for basic
// building blocks of double-word arithmetic, 2017.

#include <cmath>

#include "fast/internal/error_free.h"

namespace raycheck::fast {

using HWY_NAMESPACE::fast_two_sum;
using HWY_NAMESPACE::two_product;
using HWY_NAMESPACE::two_square;
using HWY_NAMESPACE::two_sum;
using Rounded = HWY_NAMESPACE::Rounded<double>;

/// Domain: that of two_product(); the range is that of doubles.
/// Error:  every operation and square root is off by at most kDoubleDoubleError of its result.
struct DoubleDouble {
  double high = 0;
  double low = 0;  ///< |low| <= ulp(high)/2

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}  // NOLINT: an exact conversion
  constexpr DoubleDouble(Rounded value)                  // NOLINT: an exact conversion
      : high(value.x), low(value.error) {}
  explicit operator double() const { return high; }

  DoubleDouble& operator+=(const DoubleDouble& y);
};

/// At least the relative error of every operation, u = 2^-53: 3 u^2 for sums (AccurateDWPlusDW), 7
/// u^2 for products (DWTimesDW1), 15 u^2 for quotients (DWDivDW2), and 25/8 u^2 for square roots
/// (Lefevre, Louvet, Muller, Picot and Rideau, Accurate calculation of Euclidean norms using
/// double-word arithmetic, 2023).
inline constexpr double kDoubleDoubleError = 0x1p-102;

inline DoubleDouble operator-(const DoubleDouble& x) { return Rounded{-x.high, -x.low}; }

inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {  // AccurateDWPlusDW
  const Rounded high = two_sum(x.high, y.high);
  const Rounded low = two_sum(x.low, y.low);
  const Rounded middle = fast_two_sum(high.x, high.error + low.x);
  return fast_two_sum(middle.x, low.error + middle.error);
}
inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }
inline DoubleDouble& DoubleDouble::operator+=(const DoubleDouble& y) { return *this = *this + y; }

inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {  // DWTimesDW1
  const Rounded high = two_product(x.high, y.high);
  return fast_two_sum(high.x, high.error + (x.high * y.low + x.low * y.high));
}

inline DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {  // DWDivDW2
  const double guess = x.high / y.high;
  const Rounded product = two_product(y.high, guess);  // DWTimesFP1
  const Rounded sum = fast_two_sum(product.x, y.low * guess);
  const Rounded times = fast_two_sum(sum.x, sum.error + product.error);
  const double rest = (x.high - times.x) + (x.low - times.error);
  return fast_two_sum(guess, rest / y.high);
}

inline DoubleDouble sqrt(const DoubleDouble& x) {  // SQRTDWtoDW
  if (!(x.high > 0)) return std::sqrt(x.high);
  const double guess = std::sqrt(x.high);
  const Rounded square = two_square(guess);
  const double rest = (x.high - square.x) - square.error + x.low;
  return fast_two_sum(guess, rest / (2 * guess));
}

inline bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
  return x.high < y.high || (x.high == y.high && x.low < y.low);
}
inline bool operator>(const DoubleDouble& x, const DoubleDouble& y) { return y < x; }
inline bool operator==(const DoubleDouble& x, const DoubleDouble& y) {
  return x.high == y.high && x.low == y.low;
}
inline bool operator>=(const DoubleDouble& x, const DoubleDouble& y) { return y < x || x == y; }

}  // namespace raycheck::fast
