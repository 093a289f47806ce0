#include "reference/internal/radical_sum.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include "reference/closed_form.h"

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

/// n = square^2 * rest, with every square that trial division and a last square root find.
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

std::string text_of_term(const Integer& radicand, const Rational& magnitude) {
  if (radicand == 1) return magnitude.str();
  const std::string root = "sqrt(" + radicand.str() + ")";
  return magnitude == 1 ? root : magnitude.str() + "*" + root;
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
      // sqrt(g x) sqrt(g y) = g sqrt(x y), without factoring again.
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

/// sqrt(p + q sqrt(m)) = sqrt((p + t)/2) +- sqrt((p - t)/2) where t = sqrt(p^2 - q^2 m) is
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

std::string RadicalSum::text() const {
  if (terms_.empty()) return "0";
  std::string result;
  for (const auto& [radicand, coefficient] : terms_) {
    const bool negative = coefficient < 0;
    if (result.empty()) {
      if (negative) result = "-";
    } else {
      result += negative ? " - " : " + ";
    }
    result += text_of_term(radicand, Rational(mp::abs(coefficient)));
  }
  return result;
}

RadicalSum first_root(const RadicalSum& rational) {
  return RadicalSum::square_root(rational.rational().value());
}

std::string text_of_sum(const RadicalSum& a, const RadicalSum& b, const RadicalSum& c) {
  if (const auto root = c.square_root()) return (a + b * *root).text();
  if (b.is_zero()) return a.text();
  std::string result = "sqrt(" + c.text() + ")";
  const auto factor = b.rational();
  if (factor == Rational(-1)) {
    result = "-" + result;
  } else if (!factor || *factor != 1) {
    result = (b.is_one_term() ? b.text() : "(" + b.text() + ")") + "*" + result;
  }
  if (a.is_zero()) return result;
  const std::string rest = a.text();
  return rest.front() == '-' ? result + " - " + rest.substr(1) : result + " + " + rest;
}

}  // namespace raycheck::reference
