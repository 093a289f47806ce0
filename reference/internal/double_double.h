#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "reference/enclosure.h"

namespace raycheck::reference {

/// A closed interval that certainly contains one real number x: |x - (high + low)| <= radius, where
/// high is the double nearest to high + low. It has about 104 bits, and needs no heap memory. Its
/// exponents are limited: the radius covers over- and underflow, and is infinite or NaN if nothing
/// is known. Valid only while doubles round to nearest.
/// Error:  each operation encloses the exact result. With u = 2^-53, it adds to the radius of its
///         operands at most kDoubleDoubleError of the result (for a sum, of the larger operand),
///         and kDoubleDoubleUnderflow. This is proved for products, quotients and roots in proofs/;
///         the rounding errors of sums are computed.
/// Source: T. J. Dekker, A floating-point technique for extending the available precision, 1971; M.
///         Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building
///         blocks of double-word arithmetic, 2017. The bounds here are simpler, and derived below.
class DoubleDouble {
 public:
  DoubleDouble() = default;
  explicit DoubleDouble(int value) : high_(value) {}
  explicit DoubleDouble(double value) : high_(value) {}
  explicit DoubleDouble(const Enclosure& value);

  double high() const { return high_; }
  double low() const { return low_; }
  double radius() const { return radius_; }
  Enclosure enclosure() const;

  /// Whether radius <= 2^-relative_bits |x| for every x in the interval, or the number is exact.
  bool is_within(int relative_bits) const {
    return std::isfinite(high_) &&
           (radius_ == 0 || radius_ < std::ldexp(std::abs(high_) / 2, -relative_bits));
  }
  /// The sign of all numbers in the interval; empty if they may differ.
  std::optional<int> certain_sign() const {
    if (is_exact_zero()) return 0;
    const bool is_certain = std::isfinite(high_) && (radius_ == 0 || radius_ < std::abs(high_) / 2);
    if (!is_certain) return std::nullopt;
    return high_ > 0 ? 1 : -1;
  }
  bool is_exact_zero() const { return high_ == 0 && radius_ == 0; }
  /// The double nearest to all numbers in the interval; empty if it may not be the same for all.
  std::optional<double> nearest() const {
    const double away = up(std::abs(low_) + radius_);
    const bool is_certain = high_ + away == high_ && high_ - away == high_ && std::isfinite(high_);
    return is_certain ? std::optional(high_ + 0.0) : std::nullopt;
  }
  /// Doubles above and below all numbers in the interval, at most one step away; infinite or NaN if
  /// nothing is known. (The end is high + low + radius. If this sum cancels, sum.low and therefore
  /// rest.low are 0. Otherwise rest.low is far below the last bit of end.high, and end.low is at
  /// most half of this bit.)
  double upper() const {
    const Sum tail = two_sum(low_, radius_);
    const Sum sum = two_sum(high_, tail.high);
    const Sum rest = two_sum(sum.low, tail.low);
    const Sum end = two_sum(sum.high, rest.high);
    return end.low + rest.low > 0 ? std::nextafter(end.high, HUGE_VAL) : end.high;
  }
  double lower() const { return -(-*this).upper(); }

  DoubleDouble operator-() const { return {{-high_, -low_}, radius_}; }
  DoubleDouble& operator+=(const DoubleDouble& other) { return *this = *this + other; }
  DoubleDouble& operator-=(const DoubleDouble& other) { return *this = *this - other; }
  DoubleDouble& operator*=(const DoubleDouble& other) { return *this = *this * other; }
  DoubleDouble& operator/=(const DoubleDouble& other) { return *this = *this / other; }

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b);
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b);
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b);
  friend DoubleDouble abs(const DoubleDouble& a) { return a.high_ < 0 ? -a : a; }
  /// The square root of a number that is known to be >= 0.
  friend DoubleDouble sqrt(const DoubleDouble& a);

 private:
  struct Sum {
    double high;
    double low;
  };
  DoubleDouble(Sum sum, double radius) : high_(sum.high), low_(sum.low), radius_(radius) {}

  /// a + b exactly (Knuth), unless it overflows.
  static Sum two_sum(double a, double b) {
    const double sum = a + b;
    const double of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
  }
  /// A bound on the loss by underflow in an operation on x, or with the result x.
  static double underflow_of(double x);
  /// A bound on the loss by underflow in the product or the quotient of a radius.
  static double underflow_of_radius(double radius);
  /// An upper bound on a radius whose computed value is too small by a share of at most 14 u.
  static double up(double radius) { return radius * (1 + 0x1p-49); }

  double high_ = 0;
  double low_ = 0;
  double radius_ = 0;
};

/// The error bounds of products, 9 u^2, quotients, 16 u^2, and square roots, 6 u^2; and the
/// largest.
inline constexpr double kDoubleDoubleProductError = 9 * 0x1p-106;
inline constexpr double kDoubleDoubleQuotientError = 16 * 0x1p-106;
inline constexpr double kDoubleDoubleRootError = 6 * 0x1p-106;
inline constexpr double kDoubleDoubleError = kDoubleDoubleQuotientError;
/// Exceeds the loss by underflow in one operation, a few times 2^-1075. If operands and result are
/// at least this large, nothing underflows, since their last bits are at least about 2^-107 of
/// them.
inline constexpr double kDoubleDoubleUnderflow = 0x1p-900;

inline double DoubleDouble::underflow_of(double x) {
  return std::abs(x) < kDoubleDoubleUnderflow ? kDoubleDoubleUnderflow : 0;
}

inline double DoubleDouble::underflow_of_radius(double radius) {
  return radius == 0 ? 0 : std::numeric_limits<double>::min();
}

/// The errors of the two sums of low parts are computed, so that exact sums stay exact.
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const auto high = DoubleDouble::two_sum(a.high_, b.high_);
  const auto low = DoubleDouble::two_sum(a.low_, b.low_);
  const auto rest = DoubleDouble::two_sum(high.low, low.high);
  const double rounding = std::abs(low.low) + std::abs(rest.low);
  return {DoubleDouble::two_sum(high.high, rest.high),
          DoubleDouble::up(a.radius_ + b.radius_ + rounding)};
}

/// The low part of a product, given the rounding error of the product of the high parts.
template <class N>
N rest_of_product(const N& error, const N& a_high, const N& a_low, const N& b_high,
                  const N& b_low) {
  return error + (a_high * b_low + a_low * b_high);
}
/// The remainder a - q b, with q the rounded quotient of the high parts, given the remainder of a's
/// high part.
template <class N>
N remainder_of_quotient(const N& of_high, const N& a_low, const N& q, const N& b_low) {
  return (of_high + a_low) - q * b_low;
}
/// The remainder a - h^2, with h the rounded root of the high part, given the remainder of the high
/// part; and the correction to h from the remainder.
template <class N>
N remainder_of_root(const N& of_high, const N& a_low) {
  return of_high + a_low;
}
template <class N>
N rest_of_root(const N& remainder, const N& h) {
  return remainder / (N(2) * h);
}

/// A product of two doubles is exact. Otherwise |low| <= u |high|. In units of u^2 |a.high b.high|,
/// the omitted a.low b.low is 1, the roundings of two products are 1 each, the rounding of their
/// sum, which is below 2u, is 2, and that of r, which is below 3u, is 3.
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const double p = a.high_ * b.high_;
  const double error = std::fma(a.high_, b.high_, -p);
  const double r = rest_of_product(error, a.high_, a.low_, b.high_, b.low_);
  const bool is_exact = a.low_ == 0 && b.low_ == 0;
  const double rounding = is_exact ? 0 : kDoubleDoubleProductError * std::abs(p);
  if (a.radius_ == 0 && b.radius_ == 0) {  // for example two inputs
    const double underflow = a.high_ == 0 || b.high_ == 0 ? 0 : DoubleDouble::underflow_of(p);
    return {DoubleDouble::two_sum(p, r), DoubleDouble::up(rounding + underflow)};
  }
  const double carried =
      std::abs(a.high_) * b.radius_ + std::abs(b.high_) * a.radius_ + a.radius_ * b.radius_;
  const bool is_zero = a.is_exact_zero() || b.is_exact_zero();
  const double underflow = is_zero ? 0
                                   : DoubleDouble::underflow_of(p) +
                                         DoubleDouble::underflow_of_radius(a.radius_ + b.radius_);
  return {DoubleDouble::two_sum(p, r), DoubleDouble::up(carried + rounding + underflow)};
}

/// a/b = q + (a - q b)/b. The remainder a.high - q b.high, below u |a.high|, is exact, and so is a
/// quotient of doubles without a remainder. Otherwise, in units of u^2 |q|, the rounding of the
/// remainder's sum with a.low, which is below 2u, is 2, that of q b.low 1, that of their
/// difference, which is below 3u, 3, and that of the last quotient 3; dividing by b.high instead of
/// b adds 3. The radii of the operands add |a'/b' - a/b| <= (a.radius + |a/b| b.radius)/(|b| -
/// b.radius).
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double q = a.high_ / b.high_;
  const double remainder = remainder_of_quotient(std::fma(-q, b.high_, a.high_), a.low_, q, b.low_);
  const bool is_exact = a.low_ == 0 && b.low_ == 0 && remainder == 0;
  const double rounding = is_exact ? 0 : kDoubleDoubleQuotientError * std::abs(q);
  const double size = std::abs(b.high_);
  // The quotient is unknown if the divisor may be 0.
  const double distance = b.radius_ < size / 4 ? size - b.radius_ : 0;
  if (a.is_exact_zero() && distance > 0) return {{q, 0}, 0};
  const double of_radius = DoubleDouble::underflow_of_radius(a.radius_ + b.radius_);
  const double carried =
      (a.radius_ + std::abs(q) * b.radius_ + of_radius + DoubleDouble::underflow_of(a.high_)) /
      distance;
  return {DoubleDouble::two_sum(q, remainder / b.high_),
          DoubleDouble::up(carried + rounding + of_radius + DoubleDouble::underflow_of(q))};
}

/// sqrt(a) = h + (a - h^2)/(sqrt(a) + h). The remainder a.high - h^2, below 2u h^2, is exact, and
/// so is the root of a double without a remainder. Otherwise, in units of u^2 h, the rounding of
/// the remainder's sum with a.low, which is below 3u h^2, is 1.5, and that of the quotient 1.5;
/// dividing by 2h instead of sqrt(a) + h adds 1.2. Together, with higher orders, this is less
/// than 6. The radius of the operand adds |sqrt(a') - sqrt(a)| <= a.radius/sqrt(a). The root of a
/// negative centre is NaN.
inline DoubleDouble sqrt(const DoubleDouble& a) {
  if (a.is_exact_zero()) return a;
  const double h = std::sqrt(a.high_);
  const double remainder = remainder_of_root(std::fma(-h, h, a.high_), a.low_);
  const double rounding = a.low_ == 0 && remainder == 0 ? 0 : kDoubleDoubleRootError * h;
  const double carried = (a.radius_ + DoubleDouble::underflow_of(a.high_)) / h;
  return {DoubleDouble::two_sum(h, rest_of_root(remainder, h)),
          DoubleDouble::up(carried + rounding + DoubleDouble::underflow_of_radius(a.radius_))};
}

/// While an object lives, doubles round to nearest, in every rounding mode of the caller.
class NearestGuard {
 public:
  NearestGuard();
  ~NearestGuard();
  NearestGuard(const NearestGuard&) = delete;
  NearestGuard& operator=(const NearestGuard&) = delete;

 private:
  unsigned before_;
};

// With sanitizers, the code would be too large for one function.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define RAYCHECK_FLATTEN
#else
#define RAYCHECK_FLATTEN gnu::flatten,
#endif

// Call f(). They are separate functions, so that the compiler moves no operation to where doubles
// round upward.
template <class F>
[[RAYCHECK_FLATTEN gnu::noinline]] auto called(const F& f) {
  return f();
}
#ifdef __x86_64__
template <class F>
[[ RAYCHECK_FLATTEN gnu::noinline, gnu::target("fma") ]] auto called_with_fma(const F& f) {
  return f();
}
inline const bool has_fma = [] {
  __builtin_cpu_init();
  return __builtin_cpu_supports("fma") != 0;
}();
#endif

/// Calls f(), which computes in double-doubles, with fused multiply-adds if the processor has them.
template <class F>
auto by_double_doubles(const F& f) {
  const NearestGuard guard;
#ifdef __x86_64__
  if (has_fma) return called_with_fma(f);
#endif
  return called(f);
}

}  // namespace raycheck::reference
