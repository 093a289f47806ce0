#include "reference/account/internal/radical_sum.h"

#include <stdexcept>
#include <utility>
#include <vector>

namespace raycheck::reference {
namespace {

namespace mp = boost::multiprecision;

const std::vector<unsigned>& trial_primes() {
  static const std::vector<unsigned> primes = [] {
    std::vector<bool> composite(kLargestTrialPrime + 1);
    std::vector<unsigned> result;
    for (unsigned p = 2; p <= static_cast<unsigned>(kLargestTrialPrime); ++p) {
      if (composite[p]) continue;
      result.push_back(p);
      for (std::uint64_t q = std::uint64_t{p} * p; q <= kLargestTrialPrime; q += p) {
        composite[static_cast<std::size_t>(q)] = true;
      }
    }
    return result;
  }();
  return primes;
}

/// n = square^2 * rest. Squares are found by trial division and by a square root of what is left.
struct SquareFactor {
  Integer square{1};
  Integer rest{1};
};

SquareFactor take_out_squares(Integer n) {
  SquareFactor result;
  const unsigned twos = n == 0 ? 0 : static_cast<unsigned>(mp::lsb(n));
  n >>= twos;
  result.square <<= twos / 2;
  result.rest <<= twos % 2;
  for (const unsigned p : trial_primes()) {
    if (n < Integer(p) * p) break;
    while (mpz_divisible_ui_p(n.backend().data(), p) != 0) {
      n /= p;
      if (mpz_divisible_ui_p(n.backend().data(), p) != 0) {
        n /= p;
        result.square *= p;
      } else {
        result.rest *= p;
      }
    }
  }
  Integer remainder;
  const Integer root = mp::sqrt(n, remainder);
  if (remainder == 0) {
    result.square *= root;
  } else {
    result.rest *= n;
  }
  return result;
}

ClosedForm::Natural natural(const Integer& n) {
  const auto twos = static_cast<unsigned>(mp::lsb(n));
  const Integer odd = n >> twos;
  if (twos < kFewestTwos || odd > kLargestOdd) return {n.str()};
  return {n.str(), odd.convert_to<unsigned>(), twos};
}

ClosedForm::Term rational_term(const Rational& value) {
  return {value < 0, natural(mp::abs(mp::numerator(value))), natural(mp::denominator(value))};
}

}  // namespace

RadicalSum RadicalSum::square_root(const Rational& radicand) {
  if (radicand < 0) throw std::domain_error("square root of " + radicand.str());
  const Integer denominator = mp::denominator(radicand);
  const SquareFactor factor = take_out_squares(mp::numerator(radicand) * denominator);
  RadicalSum result;
  result.add(factor.rest, radicand == 0 ? Rational(0) : Rational(factor.square, denominator));
  return result;
}

void RadicalSum::add(const Integer& radicand, const Rational& coefficient) {
  if (coefficient == 0) return;
  const auto [term, inserted] = terms_.emplace(radicand, coefficient);
  if (inserted) return;
  term->second += coefficient;
  if (term->second == 0) terms_.erase(term);
}

RadicalSum& RadicalSum::operator+=(const RadicalSum& other) {
  for (const auto& [radicand, coefficient] : other.terms_) add(radicand, coefficient);
  return *this;
}

RadicalSum RadicalSum::operator-() const {
  RadicalSum result = *this;
  for (auto& [radicand, coefficient] : result.terms_) coefficient = -coefficient;
  return result;
}

RadicalSum operator*(const RadicalSum& a, const RadicalSum& b) {
  RadicalSum result;
  for (const auto& [radicand_a, coefficient_a] : a.terms_) {
    for (const auto& [radicand_b, coefficient_b] : b.terms_) {
      // sqrt(g x) sqrt(g y) = g sqrt(x y), so that x y need not be factored again.
      const Integer common = mp::gcd(radicand_a, radicand_b);
      result.add((radicand_a / common) * (radicand_b / common),
                 coefficient_a * coefficient_b * Rational(common));
    }
  }
  return result;
}

RadicalSum& RadicalSum::operator/=(const RadicalSum& divisor) {
  if (!divisor.is_one_term()) throw std::domain_error("RadicalSum: division by a sum");
  const auto& [radicand, coefficient] = *divisor.terms_.begin();
  RadicalSum inverse;
  inverse.add(radicand, 1 / (coefficient * Rational(radicand)));
  return *this *= inverse;
}

std::optional<Rational> RadicalSum::rational() const {
  if (terms_.empty()) return Rational(0);
  if (terms_.size() > 1 || terms_.begin()->first != 1) return std::nullopt;
  return terms_.begin()->second;
}

/// By sqrt(p + q sqrt(m)) = sqrt((p + t)/2) +- sqrt((p - t)/2), if t = sqrt(p^2 - q^2 m) is
/// rational.
std::optional<RadicalSum> RadicalSum::square_root() const {
  if (const auto value = rational()) return square_root(*value);
  if (terms_.size() != 2 || terms_.rbegin()->first != 1) return std::nullopt;
  const auto& [m, q] = *terms_.begin();
  const Rational& p = terms_.rbegin()->second;
  const Rational t_sq = p * p - q * q * Rational(m);
  if (p < 0 || t_sq < 0) return std::nullopt;
  const auto t = square_root(t_sq).rational();
  if (!t) return std::nullopt;
  const RadicalSum larger = square_root(Rational((p + *t) / 2));
  const RadicalSum smaller = square_root(Rational((p - *t) / 2));
  return q > 0 ? larger + smaller : larger - smaller;
}

ClosedForm RadicalSum::closed_form() const {
  ClosedForm result;
  for (const auto& [radicand, coefficient] : terms_) {
    ClosedForm::Term& term = result.terms.emplace_back(rational_term(coefficient));
    if (radicand != 1) term.radicands.push_back({{rational_term(Rational(radicand))}});
  }
  return result;
}

RadicalSum first_root(const RadicalSum& rational) {
  return RadicalSum::square_root(rational.rational().value());
}

ClosedForm closed_form_of_sum(const RadicalSum& a, const RadicalSum& b, const RadicalSum& c) {
  if (const auto root = c.square_root()) return (a + b * *root).closed_form();
  ClosedForm result = a.closed_form();
  if (b.is_zero()) return result;
  ClosedForm coefficient = b.closed_form();
  ClosedForm::Term nested;
  if (b.is_one_term()) {
    nested = std::move(coefficient.terms.front());
  } else {
    nested.sums.push_back(std::move(coefficient));
  }
  nested.radicands.push_back(c.closed_form());
  result.terms.insert(result.terms.begin(), std::move(nested));
  return result;
}

}  // namespace raycheck::reference
