#pragma once

// From a quantity as a function of a lift to its condition number. Internal to reference/.

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "reference/account/condition.h"
#include "reference/account/internal/dual.h"
#include "reference/internal/ray_impl.h"

namespace raycheck::reference {

inline constexpr int kSphereInputs = 4;
inline constexpr int kGivenInputs = 6 + kSphereInputs;
inline constexpr int kCameraInputs = 14 + kSphereInputs;

/// Records what it lifts.
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

/// The condition number, where the intervals are narrow enough to tell.
std::optional<double> narrow_condition(const Sensitivity<Interval>& sensitivity);

/// Precisions of the balls: the first, and the last, past which a width is taken to be infinite.
inline constexpr int kFirstConditionBits = 128;
inline constexpr int kLastConditionBits = 1 << 16;

/// The same for balls; is_zero() says whether q is exactly 0, and is called if its ball holds 0.
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

/// The condition number of quantity(lift), a dual number or a vector of them; quantity is called
/// with a DualLift of N inputs over intervals, and then over balls.
template <int N, class Quantity, class IsZero>
double condition_number(Quantity quantity, IsZero is_zero, Arithmetic arithmetic) {
  if (arithmetic == Arithmetic::kFiltered) {
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
