#pragma once

// The number type of proofs: intervals with rational ends. With them, every program that has
// integers can recompute the formulas of reference/internal/formulas.h. Internal to reference/.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reference/internal/kernels.h"

namespace raycheck::reference {

/// 2^exponent
inline Rational power_of_two(std::int64_t exponent) {
  const auto shift = static_cast<unsigned long>(exponent < 0 ? -exponent : exponent);
  const Integer power = Integer(1) << shift;
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}
/// The largest integer <= x.
inline Integer floor_of(const Rational& x) {
  Integer quotient;
  mpz_fdiv_q(quotient.backend().data(), mpq_numref(x.backend().data()),
             mpq_denref(x.backend().data()));
  return quotient;
}
/// An e with 2^(e-1) < |x| < 2^(e+1), for x != 0.
inline std::int64_t exponent_of(const Rational& x) {
  const auto size = [](const Integer& n) {
    return static_cast<std::int64_t>(boost::multiprecision::msb(n));
  };
  return size(boost::multiprecision::abs(boost::multiprecision::numerator(x))) -
         size(boost::multiprecision::denominator(x));
}

/// All numbers from low to high. Only square roots are rounded: they are enclosed to `bits`
/// significant bits, and are exact if they have no more. The `bits` of a result are the larger of
/// those of its operands.
class RationalInterval {
 public:
  RationalInterval() = default;
  explicit RationalInterval(int value) : low_(value), high_(value) {}
  RationalInterval(const Rational& value, int bits) : low_(value), high_(value), bits_(bits) {}
  RationalInterval(Rational low, Rational high, int bits)
      : low_(std::move(low)), high_(std::move(high)), bits_(bits) {}

  const Rational& low() const { return low_; }
  const Rational& high() const { return high_; }
  int bits() const { return bits_; }
  bool is_exact() const { return low_ == high_; }

  RationalInterval operator-() const { return {-high_, -low_, bits_}; }
  friend RationalInterval operator+(const RationalInterval& a, const RationalInterval& b) {
    return {a.low_ + b.low_, a.high_ + b.high_, std::max(a.bits_, b.bits_)};
  }
  friend RationalInterval operator-(const RationalInterval& a, const RationalInterval& b) {
    return a + -b;
  }
  friend RationalInterval operator*(const RationalInterval& a, const RationalInterval& b) {
    const int bits = std::max(a.bits_, b.bits_);
    if (a.is_exact() && b.is_exact()) return {a.low_ * b.low_, bits};
    const auto [low, high] =
        std::minmax({a.low_ * b.low_, a.low_ * b.high_, a.high_ * b.low_, a.high_ * b.high_});
    return {low, high, bits};
  }
  /// Throws std::domain_error if the divisor may be 0.
  friend RationalInterval operator/(const RationalInterval& a, const RationalInterval& b) {
    if (b.low_ <= 0 && b.high_ >= 0) throw std::domain_error("division by what may be 0");
    return a * RationalInterval(1 / b.high_, 1 / b.low_, b.bits_);
  }
  RationalInterval& operator+=(const RationalInterval& other) { return *this = *this + other; }
  RationalInterval& operator-=(const RationalInterval& other) { return *this = *this - other; }
  RationalInterval& operator*=(const RationalInterval& other) { return *this = *this * other; }
  RationalInterval& operator/=(const RationalInterval& other) { return *this = *this / other; }

 private:
  Rational low_;
  Rational high_;
  int bits_ = 1;
};

using RationalKernel = CGAL::Simple_cartesian<RationalInterval>;

struct RationalLift {
  using Kernel = RationalKernel;
  int bits;
  RationalInterval operator()(double value) const { return {Rational(value), bits}; }
  RationalInterval constant(double value) const { return (*this)(value); }
};

/// The square root of an exact number > 0, between two dyadic rationals of bits() bits.
inline RationalInterval first_root(const RationalInterval& radicand) {
  const Rational& x = radicand.low();
  const int bits = radicand.bits();
  // sqrt(x) = sqrt(x 4^shift) / 2^shift, and x 4^shift has at least 2 * bits bits.
  const std::int64_t shift = bits + 1 - exponent_of(x) / 2;
  const Rational scaled = x * power_of_two(2 * shift);
  const Integer whole = floor_of(scaled);
  Integer remainder;
  const Integer root = boost::multiprecision::sqrt(whole, remainder);
  const Rational low = Rational(root) * power_of_two(-shift);
  if (remainder == 0 && Rational(whole) == scaled) return {low, bits};
  return {low, Rational(Integer(root + 1)) * power_of_two(-shift), bits};
}
inline RationalInterval second_root(const RationalInterval& radicand) {
  return first_root(radicand);
}

inline std::optional<int> certain_sign(const RationalInterval& value) {
  if (value.low() > 0) return 1;
  if (value.high() < 0) return -1;
  if (value.low() == 0 && value.high() == 0) return 0;
  return std::nullopt;
}

}  // namespace raycheck::reference
