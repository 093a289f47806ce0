#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace raycheck::scene {

/// All reals from low to high; infinite where nothing is known.
/// Error:  an operation's result encloses its values for all reals in the operands; unless these
///         are tiny or past the largest double, each end is at most kBoundsMaxUlp ulp too far out.
/// Domain: doubles that round to nearest; low <= high, neither NaN.
struct Bounds {
  double low = 0;
  double high = 0;

  static Bounds exactly(double value) { return {value, value}; }
  static Bounds everything() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  bool contains(double value) const { return low <= value && value <= high; }
};

// How far a real may be from the double x it was rounded to: half an ulp, or half the least double
// (sums never need the latter). Beyond the largest double, any distance.
inline constexpr double kBoundsWiden = 0x1p-52;
inline constexpr double kBoundsTiny = 0x1p-960;
inline constexpr int kBoundsMaxUlp = 3;

/// Below any real that rounds to x, a normal double.
template <class N>
N lowered(const N& x, const N& magnitude, double widen = kBoundsWiden) {
  return x - magnitude * N(widen);
}

inline double bound_below(double x) {
  constexpr double kMost = std::numeric_limits<double>::max();
  if (x > kMost) return kMost;
  if (!(x >= -kMost)) return -std::numeric_limits<double>::infinity();
  if (std::abs(x) < kBoundsTiny && x != 0) {
    return x - (std::abs(x) * kBoundsWiden + std::numeric_limits<double>::denorm_min());
  }
  return lowered(x, std::abs(x));
}
inline double bound_above(double x) { return -bound_below(-x); }

inline Bounds operator-(const Bounds& x) { return {-x.high, -x.low}; }
inline Bounds operator+(const Bounds& x, const Bounds& y) {
  return {bound_below(x.low + y.low), bound_above(x.high + y.high)};
}
inline Bounds operator-(const Bounds& x, const Bounds& y) { return x + -y; }

/// A product of reals: 0 times anything, even infinity, is 0; an underflow is not.
struct RoundedProduct {
  double low, high;
};
inline RoundedProduct bounded_product(double x, double y) {
  if (x == 0 || y == 0) return {0, 0};
  const double product = x * y;
  if (product == 0) {
    const double least = std::numeric_limits<double>::denorm_min();
    return {-least, least};
  }
  return {bound_below(product), bound_above(product)};
}

inline Bounds operator*(const Bounds& x, const Bounds& y) {
  const RoundedProduct products[] = {bounded_product(x.low, y.low), bounded_product(x.low, y.high),
                                     bounded_product(x.high, y.low),
                                     bounded_product(x.high, y.high)};
  Bounds result{products[0].low, products[0].high};
  for (const RoundedProduct& product : products) {
    result = {std::min(result.low, product.low), std::max(result.high, product.high)};
  }
  return result;
}

inline Bounds square(const Bounds& x) {
  const double most = std::max(std::abs(x.low), std::abs(x.high));
  const double least = x.contains(0) ? 0 : std::min(std::abs(x.low), std::abs(x.high));
  return {std::max(0.0, bounded_product(least, least).low), bounded_product(most, most).high};
}

/// All reals if the divisor may be 0.
inline Bounds operator/(const Bounds& x, const Bounds& y) {
  if (y.contains(0)) return Bounds::everything();
  const double quotients[] = {x.low / y.low, x.low / y.high, x.high / y.low, x.high / y.high};
  Bounds result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double quotient : quotients) {
    if (std::isnan(quotient)) return Bounds::everything();
    // A computed 0 may be an underflow from either side.
    const double least = quotient == 0 ? std::numeric_limits<double>::denorm_min() : 0;
    result = {std::min(result.low, bound_below(quotient) - least),
              std::max(result.high, bound_above(quotient) + least)};
  }
  return result;
}

/// x 2^exponent
inline Bounds scaled(const Bounds& x, int exponent) {
  if (exponent == 0) return x;
  const auto scale = [exponent](double end) {
    const double result = std::ldexp(end, exponent);
    const bool exact = end == 0 || (std::isfinite(result) && std::abs(result) > kBoundsTiny);
    return exact ? Bounds::exactly(result) : Bounds{bound_below(result), bound_above(result)};
  };
  const double least = std::numeric_limits<double>::denorm_min();
  const Bounds low = scale(x.low), high = scale(x.high);
  return {low.low - (x.low != 0 && low.low == 0 ? least : 0),
          high.high + (x.high != 0 && high.high == 0 ? least : 0)};
}

/// Of the part of x that is not negative.
inline Bounds sqrt(const Bounds& x) {
  return {std::max(0.0, bound_below(std::sqrt(std::max(0.0, x.low)))),
          bound_above(std::sqrt(std::max(0.0, x.high)))};
}

}  // namespace raycheck::scene
