#pragma once

// MPFR comes first: FLINT 3 declares functions on MPFR's floats only after MPFR.
// clang-format off
#include <mpfr.h>
#include <arb.h>
// clang-format on

#include <optional>
#include <utility>

#include "reference/internal/triple.h"

namespace raycheck::reference {

/// A closed interval that certainly contains one real number: an Arb ball (midpoint and radius with
/// unlimited exponents) with a working precision. The results of operations enclose the exact
/// results; their precision is the larger of those of the operands. Use an object in one thread
/// only; different objects are independent. FLINT caches memory per thread: a thread may call
/// flint_cleanup() before it ends.
class Enclosure {
 public:
  Enclosure() { arb_init(ball_); }
  explicit Enclosure(int value) : Enclosure() { arb_set_si(ball_, value); }
  /// A double, exactly; `bits` is the precision of results computed from it.
  Enclosure(double value, int bits);
  /// All numbers within |value| * relative_change of value.
  static Enclosure within(double value, double relative_change, int bits);

  Enclosure(const Enclosure& other) : Enclosure() { *this = other; }
  /// Copies the ball's bytes, to which no pointer refers.
  Enclosure(Enclosure&& other) noexcept : bits_(other.bits_) {
    *ball_ = *other.ball_;
    arb_init(other.ball_);
  }
  Enclosure& operator=(const Enclosure& other);
  Enclosure& operator=(Enclosure&& other) noexcept {
    swap(other);
    return *this;
  }
  /// Most balls own no memory, and need no call.
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
  /// The sign of all numbers in the ball; empty if they differ.
  std::optional<int> certain_sign() const;
  /// Doubles below and above all numbers in the ball; infinite beyond the largest double.
  double lower() const;
  double upper() const;
  /// The doubles nearest to the ball's two ends (first rounded outward to bits() bits), ties to
  /// even. They are equal if the ball determines the correctly rounded value.
  double lower_rounded() const;
  double upper_rounded() const;
  /// Whether radius <= 2^-relative_bits |midpoint|.
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
// These reuse the memory of a temporary for the result.
inline Enclosure operator+(Enclosure&& a, const Enclosure& b) { return std::move(a += b); }
inline Enclosure operator-(Enclosure&& a, const Enclosure& b) { return std::move(a -= b); }
inline Enclosure operator*(Enclosure&& a, const Enclosure& b) { return std::move(a *= b); }
inline Enclosure operator/(Enclosure&& a, const Enclosure& b) { return std::move(a /= b); }
/// The square root of a number that is known to be >= 0; the negative part of the ball is cut off.
Enclosure sqrt(const Enclosure& value);
Enclosure abs(const Enclosure& value);

using Enclosure3 = Triple<Enclosure>;

}  // namespace raycheck::reference
