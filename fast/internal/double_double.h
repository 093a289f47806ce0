#pragma once

// Pairs of doubles (fast/internal/error_free.h) as a number type. Internal to fast/.

#include <cmath>

#include "fast/internal/error_free.h"

namespace raycheck::fast {

using HWY_NAMESPACE::pair_root;
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
  Rounded pair() const { return {high, low}; }

  DoubleDouble& operator+=(const DoubleDouble& y);
};

/// At least the relative error of every operation, u = 2^-53: 3 u^2 for sums (AccurateDWPlusDW), 7
/// u^2 for products (DWTimesDW1), 15 u^2 for quotients (DWDivDW2), and 25/8 u^2 for square roots
/// (Lefevre, Louvet, Muller, Picot and Rideau, Accurate calculation of Euclidean norms using
/// double-word arithmetic, 2023).
inline constexpr double kDoubleDoubleError = 0x1p-102;

inline DoubleDouble operator-(const DoubleDouble& x) { return Rounded{-x.high, -x.low}; }

inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
  return x.pair() + y.pair();
}
inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }
inline DoubleDouble& DoubleDouble::operator+=(const DoubleDouble& y) { return *this = *this + y; }

inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
  return x.pair() * y.pair();
}
inline DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
  return x.pair() / y.pair();
}
inline DoubleDouble sqrt(const DoubleDouble& x) {
  return x.high > 0 ? DoubleDouble(pair_root(x.pair())) : std::sqrt(x.high);
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
