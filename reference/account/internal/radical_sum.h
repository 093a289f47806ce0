#pragma once

#include <functional>
#include <map>
#include <optional>

#include "reference/account/closed_form.h"
#include "reference/internal/kernels.h"

namespace raycheck::reference {

/// The symbolic number type of the formulas: a sum of rationals times square roots of distinct
/// positive integers, which are square-free as far as trial division shows. The divisor must be a
/// single term, which is enough for the formulas. Internal to reference/.
class RadicalSum {
 public:
  RadicalSum() = default;
  explicit RadicalSum(int value) : RadicalSum(Rational(value)) {}
  explicit RadicalSum(const Rational& value) { add(Integer(1), value); }
  /// The square root of a rational >= 0; otherwise throws std::domain_error.
  static RadicalSum square_root(const Rational& radicand);

  RadicalSum& operator+=(const RadicalSum& other);
  RadicalSum& operator-=(const RadicalSum& other) { return *this += -other; }
  RadicalSum& operator*=(const RadicalSum& other) { return *this = *this * other; }
  /// Domain: `divisor` is one term; otherwise throws std::domain_error.
  RadicalSum& operator/=(const RadicalSum& divisor);
  RadicalSum operator-() const;
  friend RadicalSum operator*(const RadicalSum& a, const RadicalSum& b);

  /// The value, if no square root is left.
  std::optional<Rational> rational() const;
  /// The square root, if it is also a sum of at most two such terms.
  std::optional<RadicalSum> square_root() const;
  bool is_zero() const { return terms_.empty(); }
  bool is_one_term() const { return terms_.size() == 1; }
  ClosedForm closed_form() const;

 private:
  void add(const Integer& radicand, const Rational& coefficient);

  /// The coefficient of each radicand, larger radicands first; that of 1 is the rational part. No
  /// coefficient is 0.
  std::map<Integer, Rational, std::greater<>> terms_;
};

inline RadicalSum operator+(RadicalSum a, const RadicalSum& b) { return a += b; }
inline RadicalSum operator-(RadicalSum a, const RadicalSum& b) { return a -= b; }
inline RadicalSum operator/(RadicalSum a, const RadicalSum& b) { return a /= b; }

// The square roots of a camera's field, as in reference/internal/kernels.h.
RadicalSum first_root(const RadicalSum& rational);
inline RadicalSum second_root(const RadicalSum& rational) { return first_root(rational); }

/// b sqrt(c) + a; the root is evaluated if sqrt(c) is a RadicalSum.
ClosedForm closed_form_of_sum(const RadicalSum& a, const RadicalSum& b, const RadicalSum& c);

}  // namespace raycheck::reference
