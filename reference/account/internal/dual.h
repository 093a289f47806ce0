#pragma once

// Numbers that carry their derivatives: the formulas of reference/internal/formulas.h, run with
// them, give exact derivatives by the chain rule (forward-mode automatic differentiation). Internal
// to reference/.

#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "reference/internal/kernels.h"

namespace raycheck::reference {

/// A value and its derivatives by at most N inputs, each a T that encloses the true one. A bit set
/// says which inputs the value depends on; derivatives by the others are 0 and not stored, which
/// saves most of the work.
template <class T, int N>
class Dual {
  static_assert(N <= 32, "one bit an input");

 public:
  Dual() : value_(0) {}
  explicit Dual(int value) : value_(value) {}
  explicit Dual(const T& value) : value_(value) {}
  /// The input of index k.
  static Dual input(const T& value, int k) {
    Dual result(value);
    result.depends_on_ = 1U << static_cast<unsigned>(k);
    result.derivatives_[static_cast<std::size_t>(k)] = T(1);
    return result;
  }

  const T& value() const { return value_; }
  bool depends_on(int k) const { return ((depends_on_ >> static_cast<unsigned>(k)) & 1U) != 0; }
  /// Domain: depends_on(k).
  const T& derivative(int k) const { return derivatives_[static_cast<std::size_t>(k)]; }

  Dual& operator+=(const Dual& other) {
    value_ += other.value_;
    add(other, [](const T& derivative) -> const T& { return derivative; });
    return *this;
  }
  Dual& operator-=(const Dual& other) { return *this += -other; }
  Dual& operator*=(const Dual& other) { return *this = *this * other; }
  Dual& operator/=(const Dual& other) { return *this = *this / other; }

  Dual operator-() const {
    Dual result(-value_);
    result.add(*this, [](const T& derivative) { return -derivative; });
    return result;
  }
  friend Dual operator+(const Dual& a, const Dual& b) {
    Dual result = a;
    return result += b;
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    Dual result = a;
    return result -= b;
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual result(a.value_ * b.value_);
    result.add_times(b.value_, a);
    result.add_times(a.value_, b);
    return result;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    Dual result(a.value_ / b.value_);
    const T inverse = T(1) / b.value_;
    result.add_times(inverse, a);
    result.add_times(-(result.value_ * inverse), b);
    return result;
  }
  friend Dual sqrt(const Dual& a) {
    using CGAL::sqrt;
    Dual result{T(sqrt(a.value_))};
    result.add_times(T(1) / (T(2) * result.value_), a);
    return result;
  }
  friend Dual first_root(const Dual& radicand) { return sqrt(radicand); }
  friend Dual second_root(const Dual& radicand) { return sqrt(radicand); }

 private:
  /// Adds term(derivative of other) to each derivative.
  template <class Term>
  void add(const Dual& other, Term term) {
    for (unsigned both = depends_on_ & other.depends_on_; both != 0; both &= both - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(both));
      derivatives_[k] += term(other.derivatives_[k]);
    }
    for (unsigned fresh = other.depends_on_ & ~depends_on_; fresh != 0; fresh &= fresh - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(fresh));
      derivatives_[k] = term(other.derivatives_[k]);
    }
    depends_on_ |= other.depends_on_;
  }
  void add_times(const T& factor, const Dual& other) {
    add(other, [&factor](const T& derivative) { return factor * derivative; });
  }

  T value_;
  unsigned depends_on_ = 0;       ///< Bit k: the input of index k.
  std::array<T, N> derivatives_;  ///< Valid only for inputs in depends_on_.
};

/// Lifts doubles to duals: each input that it lifts becomes the next one to differentiate by. It
/// counts them, so use one lift for one evaluation, and lift each input once.
template <class BaseLift, int N>
class DualLift {
 public:
  using Base = decltype(std::declval<const BaseLift&>()(0.0));
  using Number = Dual<Base, N>;
  using BaseKernel = CGAL::Simple_cartesian<Base>;
  using Kernel = CGAL::Simple_cartesian<Number>;

  explicit DualLift(const BaseLift& base) : base_(base) {}

  Number operator()(double value) const { return input(base_(value)); }
  Number constant(double value) const { return Number(base_.constant(value)); }
  /// An input that is itself the result of earlier steps.
  Number input(const Base& value) const {
    inputs_[static_cast<std::size_t>(count_)] = value;
    return Number::input(value, count_++);
  }
  typename Kernel::Vector_3 input(const typename BaseKernel::Vector_3& value) const {
    return {input(value.x()), input(value.y()), input(value.z())};
  }

  const BaseLift& base() const { return base_; }
  /// How many inputs were lifted.
  int count() const { return count_; }
  const Base& input_value(int k) const { return inputs_[static_cast<std::size_t>(k)]; }

 private:
  BaseLift base_;
  mutable int count_ = 0;
  mutable std::array<Base, N> inputs_;
};

}  // namespace raycheck::reference
