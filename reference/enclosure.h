#pragma once

// In this order: FLINT 3 declares functions on MPFR's floats only after MPFR.
// clang-format off
#include <mpfr.h>
#include <arb.h>
// clang-format on

#include <optional>
#include <utility>

#include "reference/internal/triple.h"

namespace raycheck::reference {

/// A closed interval that certainly holds one real number: an Arb ball (midpoint and radius with
/// unlimited exponents) that carries its working precision. Arithmetic encloses the exact result;
/// precision is the larger of the operands'. One object per thread; different objects are
/// independent. FLINT caches memory per thread: a thread that ends may call flint_cleanup() first.
class Enclosure {
 public:
  Enclosure() { arb_init(ball_); }
  explicit Enclosure(int value) : Enclosure() { arb_set_si(ball_, value); }
  /// Exactly this double; `bits` is the precision of results computed from it.
  Enclosure(double value, int bits);
  /// Everything within |value| * relative_change of value.
  static Enclosure within(double value, double relative_change, int bits);

  Enclosure(const Enclosure& other) : Enclosure() { *this = other; }
  /// Copies the ball's bytes: no pointer refers to them.
  Enclosure(Enclosure&& other) noexcept : bits_(other.bits_) {
    *ball_ = *other.ball_;
    arb_init(other.ball_);
  }
  Enclosure& operator=(const Enclosure& other);
  Enclosure& operator=(Enclosure&& other) noexcept {
    swap(other);
    return *this;
  }
  /// Most balls own no memory, and are dropped without a call.
  ~Enclosure() {
    const bool owns_memory = ARF_HAS_PTR(arb_midref(ball_)) ||
                             COEFF_IS_MPZ(ARF_EXP(arb_midref(ball_))) ||
                             COEFF_IS_MPZ(MAG_EXP(arb_radref(ball_)));
    if (owns_memory) arb_clear(ball_);
  }

  Enclosure& operator+=(const Enclosure& other);
  Enclosure& operator-=(const Enclosure& other);
  Enclosure& operator*=(const Enclosure& other);
  Enclosure& operator/=(const Enclosure& other);
  Enclosure operator-() const;

  int bits() const { return bits_; }
  bool contains_zero() const { return arb_contains_zero(ball_) != 0; }
  /// The sign of every number in the ball; empty when they differ.
  std::optional<int> certain_sign() const;
  /// Doubles below and above every number in the ball (infinite past the double range).
  double lower() const;
  double upper() const;
  /// The doubles nearest to the ball's two ends (moved outward to bits() first), ties to even:
  /// equal when the ball determines the correctly rounded value.
  double lower_rounded() const;
  double upper_rounded() const;
  /// True when radius <= 2^-relative_bits |midpoint|.
  bool is_within(int relative_bits) const;

  const arb_struct* ball() const { return ball_; }
  arb_struct* ball() { return ball_; }

 private:
  void swap(Enclosure& other) noexcept {
    arb_swap(ball_, other.ball_);
    const int bits = bits_;
    bits_ = other.bits_;
    other.bits_ = bits;
  }
  template <auto kOperation>
  Enclosure& apply(const Enclosure& other);
  template <auto kOperation>
  static Enclosure result_of(const Enclosure& a, const Enclosure& b);
  friend Enclosure operator+(const Enclosure& a, const Enclosure& b);
  friend Enclosure operator-(const Enclosure& a, const Enclosure& b);
  friend Enclosure operator*(const Enclosure& a, const Enclosure& b);
  friend Enclosure operator/(const Enclosure& a, const Enclosure& b);

  arb_t ball_;
  int bits_ = 64;
};

Enclosure operator+(const Enclosure& a, const Enclosure& b);
Enclosure operator-(const Enclosure& a, const Enclosure& b);
Enclosure operator*(const Enclosure& a, const Enclosure& b);
Enclosure operator/(const Enclosure& a, const Enclosure& b);
// The memory of a temporary is reused for the result.
inline Enclosure operator+(Enclosure&& a, const Enclosure& b) { return std::move(a += b); }
inline Enclosure operator-(Enclosure&& a, const Enclosure& b) { return std::move(a -= b); }
inline Enclosure operator*(Enclosure&& a, const Enclosure& b) { return std::move(a *= b); }
inline Enclosure operator/(Enclosure&& a, const Enclosure& b) { return std::move(a /= b); }
/// The square root of a number known to be >= 0; cuts off the negative part of the ball.
Enclosure sqrt(const Enclosure& value);
Enclosure abs(const Enclosure& value);

using Enclosure3 = Triple<Enclosure>;

}  // namespace raycheck::reference
