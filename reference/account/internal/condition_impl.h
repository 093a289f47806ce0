#pragma once

// Numbers that carry their derivatives. With them, the formulas of reference/internal/formulas.h
// give exact derivatives by the chain rule (forward-mode automatic differentiation). And functions
// that compute the condition number of a quantity, given as a function of a lift. Internal to
// reference/.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "reference/account/condition.h"
#include "reference/internal/kernels.h"
#include "reference/internal/ray_impl.h"

namespace raycheck::reference {

/// A value and its derivatives by at most N inputs, each a T that encloses the true number. A bit
/// set says which inputs the value depends on. The other derivatives are 0 and not stored, which
/// saves most of the work.
template <class T, int N>
class Dual {
  static_assert(N <= 32, "one bit per input");

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

/// Lifts doubles to duals. Each lifted double becomes the next input to differentiate by; use a new
/// lift for each evaluation, and lift each input once.
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
  /// Lifts an input that is the result of earlier steps.
  Number input(const Base& value) const {
    inputs_[static_cast<std::size_t>(count_)] = value;
    return Number::input(value, count_++);
  }
  typename Kernel::Vector_3 input(const typename BaseKernel::Vector_3& value) const {
    return {input(value.x()), input(value.y()), input(value.z())};
  }

  const BaseLift& base() const { return base_; }
  /// The number of inputs that were lifted.
  int count() const { return count_; }
  const Base& input_value(int k) const { return inputs_[static_cast<std::size_t>(k)]; }

 private:
  BaseLift base_;
  mutable int count_ = 0;
  mutable std::array<Base, N> inputs_;
};

inline constexpr int kSphereInputs = 4;
inline constexpr int kGivenInputs = 6 + kSphereInputs;
inline constexpr int kCameraInputs = 14 + kSphereInputs;

/// Records the doubles that it lifts.
struct NotingLift {
  using Kernel = CGAL::Simple_cartesian<double>;

  double operator()(double value) const {
    noted.push_back(value);
    return value;
  }

  std::vector<double>& noted;
};

/// The inputs of a ray and of spheres, in the order of an InputChange.
inline std::vector<double> inputs_of(const ExactRay& ray, std::span<const scene::Sphere> spheres) {
  std::vector<double> result;
  const NotingLift lift{result};
  const ExactRay::Source& source = ray.source();
  if (source.camera) {
    lift_camera(lift, source.camera->camera);
  } else {
    lift_ray(lift, source.given);
  }
  for (const scene::Sphere& sphere : spheres) lift_sphere(lift, sphere);
  return result;
}

inline Interval magnitude(const Interval& x) { return CGAL::abs(x); }
inline Enclosure magnitude(const Enclosure& x) { return abs(x); }

inline Interval square(const Interval& x) { return CGAL::square(x); }
inline Enclosure square(const Enclosure& x) { return x * x; }

inline bool is_exact_zero(const Interval& x) { return x.inf() == 0 && x.sup() == 0; }
inline bool is_exact_zero(const Enclosure& x) { return x.certain_sign() == 0; }

/// |q|, and the sum of |dq/dx| |x| over the inputs.
template <class T>
struct Sensitivity {
  T size;
  T sum;
};

template <class Lift, class T, int N>
Sensitivity<T> sensitivity(const Lift& lift, const Dual<T, N>& q) {
  T sum(0);
  for (int k = 0; k < lift.count(); ++k) {
    if (!q.depends_on(k) || is_exact_zero(lift.input_value(k))) continue;
    sum += magnitude(q.derivative(k)) * magnitude(lift.input_value(k));
  }
  return {magnitude(q.value()), sum};
}

template <class Lift, class K>
Sensitivity<typename Lift::Base> sensitivity(const Lift& lift, const CGAL::Vector_3<K>& q) {
  using CGAL::sqrt;
  using T = typename Lift::Base;
  T sum(0);
  for (int k = 0; k < lift.count(); ++k) {
    if (is_exact_zero(lift.input_value(k))) continue;
    T squares(0);
    for (int axis = 0; axis < 3; ++axis) {
      if (q[axis].depends_on(k)) squares += square(q[axis].derivative(k));
    }
    sum += T(sqrt(squares)) * magnitude(lift.input_value(k));
  }
  const T& x = q.x().value();
  const T& y = q.y().value();
  const T& z = q.z().value();
  return {sqrt(square(x) + square(y) + square(z)), sum};
}

/// The condition number; empty if the intervals are too wide.
std::optional<double> narrow_condition(const Sensitivity<Interval>& sensitivity);

/// The first and the last precision of the balls. If the last is not enough, the result is
/// infinite.
inline constexpr int kFirstConditionBits = 128;
inline constexpr int kLastConditionBits = 1 << 16;

/// The condition number, from balls; empty if they are too wide. is_zero() says whether q is
/// exactly 0; it is called if the ball of q contains 0.
template <class IsZero>
std::optional<double> narrow_condition(const Sensitivity<Enclosure>& sensitivity, IsZero is_zero) {
  const auto& [size, sum] = sensitivity;
  if (sum.certain_sign() == 0) return 0;
  if (size.certain_sign() != 1) {
    if (sum.certain_sign() == 1 && is_zero()) return std::numeric_limits<double>::infinity();
    return std::nullopt;
  }
  const Enclosure condition = sum / size;
  const double bound = condition.upper();
  if (!condition.is_within(1 - std::ilogb(kConditionWidth)) && !(bound <= kNegligibleCondition)) {
    return std::nullopt;
  }
  return bound;
}

/// The condition number of quantity(lift), a dual number or a vector of them. `quantity` is called
/// with a DualLift of N inputs over intervals, then over balls.
template <int N, class Quantity, class IsZero>
double condition_number(Quantity quantity, IsZero is_zero) {
  {
    const IntervalGuard guard;
    const DualLift<IntervalLift, N> lift{IntervalLift{}};
    if (const auto condition = narrow_condition(sensitivity(lift, quantity(lift)))) {
      return *condition;
    }
  }
  std::optional<bool> zero;
  const auto asked_once = [&] {
    if (!zero) zero = is_zero();
    return *zero;
  };
  for (int bits = kFirstConditionBits; bits <= kLastConditionBits; bits *= 2) {
    const DualLift<EnclosureLift, N> lift{EnclosureLift{bits}};
    const auto condition = narrow_condition(sensitivity(lift, quantity(lift)), asked_once);
    if (condition) return *condition;
  }
  return std::numeric_limits<double>::infinity();
}

inline bool is_zero(const Enclosure3& x) {
  return is_exact_zero(x.x) && is_exact_zero(x.y) && is_exact_zero(x.z);
}

/// The exact sign of a coefficient of reference/internal/formulas.h.
template <class Coefficient>
int exact_sign_of(const ExactRay& ray, const scene::Sphere& sphere, Coefficient coefficient) {
  const ExactLift lift;
  const auto line = line_of(lift, ray.source());
  return *certain_sign(coefficient(line_and_sphere(line, lift_sphere(lift, sphere))));
}

inline bool axial_distance_is_zero(const ExactRay& ray, const scene::Sphere& sphere) {
  return exact_sign_of(ray, sphere, [](const auto& pair) { return linear_coefficient(pair); }) == 0;
}
inline bool half_chord_is_zero(const ExactRay& ray, const scene::Sphere& sphere) {
  return exact_sign_of(ray, sphere, [](const auto& pair) { return discriminant(pair); }) == 0;
}

}  // namespace raycheck::reference
