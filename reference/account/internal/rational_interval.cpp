#include "reference/account/internal/rational_interval.h"

namespace raycheck::reference {

namespace mp = boost::multiprecision;

Rational power_of_two(std::int64_t exponent) {
  const auto shift = static_cast<unsigned long>(exponent < 0 ? -exponent : exponent);
  const Integer power = Integer(1) << shift;
  return exponent < 0 ? Rational(Integer(1), power) : Rational(power);
}

Integer floor_of(const Rational& x) {
  Integer quotient;
  mpz_fdiv_q(quotient.backend().data(), mpq_numref(x.backend().data()),
             mpq_denref(x.backend().data()));
  return quotient;
}

std::int64_t exponent_of(const Rational& x) {
  const auto size = [](const Integer& n) { return static_cast<std::int64_t>(mp::msb(n)); };
  return size(mp::abs(mp::numerator(x))) - size(mp::denominator(x));
}

RationalInterval first_root(const RationalInterval& radicand) {
  const Rational& x = radicand.low();
  const int bits = radicand.bits();
  // sqrt(x) = sqrt(x 4^shift) / 2^shift, and x 4^shift has at least 2 bits bits.
  const std::int64_t shift = bits + 1 - exponent_of(x) / 2;
  const Rational scaled = x * power_of_two(2 * shift);
  const Integer whole = floor_of(scaled);
  Integer remainder;
  const Integer root = mp::sqrt(whole, remainder);
  const Rational low = Rational(root) * power_of_two(-shift);
  if (remainder == 0 && Rational(whole) == scaled) return {low, bits};
  return {low, Rational(Integer(root + 1)) * power_of_two(-shift), bits};
}

}  // namespace raycheck::reference
