#include "reference/enclosure.h"

#include <algorithm>
#include <limits>

namespace raycheck::reference {
namespace {

constexpr int kDoubleBits = std::numeric_limits<double>::digits;
/// The smallest subnormal is 2^kSmallestExponent.
constexpr int kSmallestExponent = -1074;
/// Normal doubles are at least 2^kSmallestNormalExponent.
constexpr int kSmallestNormalExponent = -1022;
/// Finite doubles are below 2^kOverflowExponent.
constexpr int kOverflowExponent = 1024;

/// An arf that clears itself.
class Float {
 public:
  Float() { arf_init(value_); }
  Float(const Float&) = delete;
  Float& operator=(const Float&) = delete;
  ~Float() { arf_clear(value_); }
  arf_struct* get() { return value_; }

 private:
  arf_t value_;
};

/// x rounded once to a double in direction `rounding`; it over- and underflows as IEEE-754 says.
/// (Rounding to 53 bits first and to a subnormal afterwards would round twice.)
double to_double(arf_srcptr x, arf_rnd_t rounding) {
  if (arf_is_zero(x)) return 0.0;
  if (!arf_is_finite(x)) return arf_get_d(x, ARF_RND_DOWN);
  const fmpz exponent = ARF_EXP(x);
  if (!COEFF_IS_MPZ(exponent) && exponent > kSmallestNormalExponent &&
      exponent < kOverflowExponent) {
    return arf_get_d(x, rounding);
  }
  const bool negative = arf_sgn(x) < 0;
  const bool to_nearest = rounding == ARF_RND_NEAR;
  const bool toward_zero = !to_nearest && (rounding == ARF_RND_FLOOR) != negative;
  const auto signed_double = [&](double magnitude) { return negative ? -magnitude : magnitude; };
  const double too_large =
      toward_zero ? std::numeric_limits<double>::max() : std::numeric_limits<double>::infinity();

  Float power;
  arf_set_si_2exp_si(power.get(), 1, kSmallestExponent - 1);
  const bool at_most_half_smallest = arf_cmpabs(x, power.get()) <= 0;
  arf_set_si_2exp_si(power.get(), 1, kSmallestExponent);
  if (arf_cmpabs(x, power.get()) < 0) {
    const bool vanishes = toward_zero || (to_nearest && at_most_half_smallest);
    return signed_double(vanishes ? 0.0 : std::numeric_limits<double>::denorm_min());
  }
  arf_set_si_2exp_si(power.get(), 1, kOverflowExponent);
  if (arf_cmpabs(x, power.get()) >= 0) return signed_double(too_large);

  const slong available = arf_abs_bound_lt_2exp_si(x) - kSmallestExponent;
  Float rounded;
  arf_set_round(rounded.get(), x, std::min<slong>(available, kDoubleBits), rounding);
  if (arf_cmpabs(rounded.get(), power.get()) >= 0) return signed_double(too_large);
  return arf_get_d(rounded.get(), ARF_RND_DOWN);
}

/// The ends of a ball as doubles. A quotient by a ball that contains 0 has no midpoint and may have
/// any value.
double low_end(const arb_t ball, int bits, arf_rnd_t rounding) {
  if (arf_is_nan(arb_midref(ball))) return -std::numeric_limits<double>::infinity();
  Float bound;
  arb_get_lbound_arf(bound.get(), ball, bits);
  return to_double(bound.get(), rounding);
}
double high_end(const arb_t ball, int bits, arf_rnd_t rounding) {
  if (arf_is_nan(arb_midref(ball))) return std::numeric_limits<double>::infinity();
  Float bound;
  arb_get_ubound_arf(bound.get(), ball, bits);
  return to_double(bound.get(), rounding);
}

}  // namespace

Enclosure::Enclosure(double value, int bits) : Enclosure() {
  arb_set_d(ball_, value);
  bits_ = bits;
}

Enclosure Enclosure::within(double value, double relative_change, int bits) {
  Enclosure result(value, bits);
  if (relative_change > 0 && value != 0) {
    Enclosure radius(relative_change, bits);
    radius *= abs(result);
    arb_add_error(result.ball_, radius.ball_);
  }
  return result;
}

Enclosure& Enclosure::operator=(const Enclosure& other) {
  arb_set(ball_, other.ball_);
  bits_ = other.bits_;
  return *this;
}

template <auto kOperation>
[[gnu::always_inline]] inline Enclosure& Enclosure::apply(const Enclosure& other) {
  bits_ = std::max(bits_, other.bits_);
  kOperation(ball_, ball_, other.ball_, bits_);
  return *this;
}

template <auto kOperation>
[[gnu::always_inline]] inline Enclosure Enclosure::result_of(const Enclosure& a,
                                                             const Enclosure& b) {
  Enclosure result;
  result.bits_ = std::max(a.bits_, b.bits_);
  kOperation(result.ball_, a.ball_, b.ball_, result.bits_);
  return result;
}

Enclosure& Enclosure::operator+=(const Enclosure& other) { return apply<arb_add>(other); }
Enclosure& Enclosure::operator-=(const Enclosure& other) { return apply<arb_sub>(other); }
Enclosure& Enclosure::operator*=(const Enclosure& other) { return apply<arb_mul>(other); }
Enclosure& Enclosure::operator/=(const Enclosure& other) { return apply<arb_div>(other); }

Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  return Enclosure::result_of<arb_add>(a, b);
}
Enclosure operator-(const Enclosure& a, const Enclosure& b) {
  return Enclosure::result_of<arb_sub>(a, b);
}
Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  return Enclosure::result_of<arb_mul>(a, b);
}
Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  return Enclosure::result_of<arb_div>(a, b);
}

Enclosure Enclosure::operator-() const {
  Enclosure result;
  result.bits_ = bits_;
  arb_neg(result.ball_, ball_);
  return result;
}

std::optional<int> Enclosure::certain_sign() const {
  if (arb_is_positive(ball_)) return 1;
  if (arb_is_negative(ball_)) return -1;
  if (arb_is_zero(ball_)) return 0;
  return std::nullopt;
}

double Enclosure::lower() const { return low_end(ball_, bits_, ARF_RND_FLOOR); }
double Enclosure::upper() const { return high_end(ball_, bits_, ARF_RND_CEIL); }
double Enclosure::lower_rounded() const { return low_end(ball_, bits_, ARF_RND_NEAR); }
double Enclosure::upper_rounded() const { return high_end(ball_, bits_, ARF_RND_NEAR); }

bool Enclosure::is_within(int relative_bits) const {
  if (arb_is_exact(ball_)) return true;
  return arb_is_finite(ball_) && arb_rel_accuracy_bits(ball_) >= relative_bits;
}

Enclosure sqrt(const Enclosure& value) {
  Enclosure result(0.0, value.bits());
  arb_sqrtpos(result.ball(), value.ball(), value.bits());
  return result;
}

Enclosure abs(const Enclosure& value) {
  Enclosure result = value;
  arb_abs(result.ball(), result.ball());
  return result;
}

}  // namespace raycheck::reference
