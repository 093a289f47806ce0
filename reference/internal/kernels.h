#pragma once

// The number types with which the formulas of reference/internal/formulas.h are instantiated.
// Internal to reference/, since it includes CGAL.

#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Sqrt_extension.h>
#include <CGAL/boost_mp.h>

#include <boost/multiprecision/gmp.hpp>
#include <cstdint>
#include <optional>

#include "reference/enclosure.h"
#include "reference/internal/double_double.h"
#include "scene/geometry.h"

namespace raycheck::reference {

/// The first stage: doubles with directed rounding. Valid only while an IntervalGuard lives.
using Interval = CGAL::Interval_nt<false>;
using IntervalGuard = CGAL::Protect_FPU_rounding<true>;
using IntervalKernel = CGAL::Simple_cartesian<Interval>;

/// The stage between intervals and balls: double-doubles. Valid only while a NearestGuard lives.
using DoubleDoubleKernel = CGAL::Simple_cartesian<DoubleDouble>;

using EnclosureKernel = CGAL::Simple_cartesian<Enclosure>;

/// The exact field Q(|w|, |u|), w = E - A, u = up x w: rationals with the square roots of |w|^2 and
/// |u|^2, adjoined one after the other. Rationals are values (without shared reference counts), so
/// that objects may be read from any thread.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using FirstExtension = CGAL::Sqrt_extension<Rational, Rational>;
using ExactNumber = CGAL::Sqrt_extension<FirstExtension, Rational>;
using ExactKernel = CGAL::Simple_cartesian<ExactNumber>;

// Lifts: they make numbers of each kind from doubles, exactly. A double is an input or a constant
// of a formula.
template <class Number>
struct PlainLift {
  using Kernel = CGAL::Simple_cartesian<Number>;
  Number operator()(double value) const { return Number(value); }
  Number constant(double value) const { return Number(value); }
};
using IntervalLift = PlainLift<Interval>;
using DoubleDoubleLift = PlainLift<DoubleDouble>;
struct EnclosureLift {
  using Kernel = EnclosureKernel;
  int bits;
  double relative_change = 0;  ///< Inputs become all numbers within this relative change.
  Enclosure operator()(double value) const {
    return Enclosure::within(value, relative_change, bits);
  }
  Enclosure constant(double value) const { return Enclosure(value, bits); }
};
struct ExactLift {
  using Kernel = ExactKernel;
  ExactNumber operator()(double value) const {
    return ExactNumber(FirstExtension(Rational(value)));
  }
  ExactNumber constant(double value) const { return (*this)(value); }
};

/// A number of pixels or an index, exactly, since they are below 2^31 (scene::kMostPixelsAcross).
template <class Lift>
auto lift_count(const Lift& lift, std::int64_t count) {
  return lift.constant(static_cast<double>(count));
}

// The two square roots of a camera's field. Approximate number types evaluate them. In the exact
// field they are the generators, or rationals if the radicand is a perfect square.
inline Interval first_root(const Interval& radicand) { return CGAL::sqrt(radicand); }
inline Interval second_root(const Interval& radicand) { return CGAL::sqrt(radicand); }
inline DoubleDouble first_root(const DoubleDouble& radicand) { return sqrt(radicand); }
inline DoubleDouble second_root(const DoubleDouble& radicand) { return sqrt(radicand); }
inline Enclosure first_root(const Enclosure& radicand) { return sqrt(radicand); }
inline Enclosure second_root(const Enclosure& radicand) { return sqrt(radicand); }
ExactNumber first_root(const ExactNumber& rational);
ExactNumber second_root(const ExactNumber& rational);

// The sign; empty if it is not certain.
inline std::optional<int> certain_sign(const Interval& value) {
  if (value.inf() > 0) return 1;
  if (value.sup() < 0) return -1;
  if (value.inf() == 0 && value.sup() == 0) return 0;
  return std::nullopt;
}
inline std::optional<int> certain_sign(const DoubleDouble& value) { return value.certain_sign(); }
inline std::optional<int> certain_sign(const Enclosure& value) { return value.certain_sign(); }
std::optional<int> certain_sign(const ExactNumber& value);

/// The sign of p + q sqrt(x) + r sqrt(y) for x, y >= 0; empty if it is not certain.
template <class Approximate>
std::optional<int> sign_of_radical_sum(const Approximate& p, const Approximate& q,
                                       const Approximate& x, const Approximate& r,
                                       const Approximate& y) {
  using CGAL::sqrt;
  return certain_sign(p + q * sqrt(x) + r * sqrt(y));
}
/// In the field the sign is found by squaring, without evaluating a root.
std::optional<int> sign_of_radical_sum(const ExactNumber& p, const ExactNumber& q,
                                       const ExactNumber& x, const ExactNumber& r,
                                       const ExactNumber& y);

template <class Lift, class Triple>
typename Lift::Kernel::Vector_3 lift_vector(const Lift& lift, const Triple& value) {
  return {lift(value.x), lift(value.y), lift(value.z)};
}

}  // namespace raycheck::reference
