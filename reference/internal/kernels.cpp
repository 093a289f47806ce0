#include "reference/internal/kernels.h"

namespace raycheck::reference {
namespace {

int exact_sign(const Rational& value) { return value.sign(); }

/// The sign of a0 + a1 sqrt(x). If the terms have opposite signs, it is that of the term with the
/// larger square.
template <class Number, class Radicand>
int sign_of_sum(const Number& a0, const Number& a1, const Radicand& x);

template <class Number>
int exact_sign(const CGAL::Sqrt_extension<Number, Rational>& value) {
  if (!value.is_extended()) return exact_sign(value.a0());
  return sign_of_sum(value.a0(), value.a1(), value.root());
}

template <class Number, class Radicand>
int sign_of_sum(const Number& a0, const Number& a1, const Radicand& x) {
  const int sign0 = exact_sign(a0);
  const int sign1 = exact_sign(x) == 0 ? 0 : exact_sign(a1);
  if (sign0 * sign1 >= 0) return sign0 != 0 ? sign0 : sign1;
  return sign0 * exact_sign(Number(a0 * a0 - a1 * a1 * Number(x)));
}

/// The rational value of a number without square roots.
const Rational& as_rational(const ExactNumber& value) { return value.a0().a0(); }

std::optional<Rational> rational_square_root(const Rational& value) {
  const auto root_of = [](const Integer& integer) -> std::optional<Integer> {
    Integer remainder;
    Integer root = boost::multiprecision::sqrt(integer, remainder);
    if (remainder != 0) return std::nullopt;
    return root;
  };
  const auto numerator = root_of(boost::multiprecision::numerator(value));
  if (!numerator) return std::nullopt;
  const auto denominator = root_of(boost::multiprecision::denominator(value));
  if (!denominator) return std::nullopt;
  return Rational(*numerator, *denominator);
}

}  // namespace

ExactNumber first_root(const ExactNumber& rational) {
  const Rational& radicand = as_rational(rational);
  if (const auto root = rational_square_root(radicand)) return ExactNumber(FirstExtension(*root));
  return ExactNumber(FirstExtension(Rational(0), Rational(1), radicand));
}

ExactNumber second_root(const ExactNumber& rational) {
  const Rational& radicand = as_rational(rational);
  if (const auto root = rational_square_root(radicand)) return ExactNumber(FirstExtension(*root));
  return ExactNumber(FirstExtension(Rational(0)), FirstExtension(Rational(1)), radicand);
}

std::optional<int> certain_sign(const ExactNumber& value) { return exact_sign(value); }

std::optional<int> sign_of_radical_sum(const ExactNumber& p, const ExactNumber& q,
                                       const ExactNumber& x, const ExactNumber& r,
                                       const ExactNumber& y) {
  const int first = sign_of_sum(p, q, x);
  const int second = exact_sign(y) == 0 ? 0 : exact_sign(r);
  if (first * second >= 0) return first != 0 ? first : second;
  // (p + q sqrt(x))^2 - r^2 y has the form a0 + a1 sqrt(x), too.
  const ExactNumber a0 = p * p + q * q * x - r * r * y;
  const ExactNumber a1 = ExactNumber(2) * p * q;
  return first * sign_of_sum(a0, a1, x);
}

}  // namespace raycheck::reference
