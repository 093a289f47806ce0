#pragma once

#include "reference/enclosure.h"
#include "scene/geometry.h"
#include "scene/precision.h"

namespace raycheck::reference {

// The errors of given doubles against enclosed exact values. Every result is an upper bound, as
// sharp as the enclosure is narrow, in u of doubles unless it is in ulp. It is infinite if the
// given value is not finite, or if the exact value is 0 and the given value is not.

/// |given - exact| / ulp(exact), where ulp(x) is the gap between the numbers of the format around
/// x.
scene::Measured ulp_error(double given, const Enclosure& exact,
                          scene::Precision precision = scene::Precision::kDouble);
scene::Measured ulp_error(double given, double exact, scene::Precision precision);

/// |given - exact| / |exact|
scene::Measured relative_error(const scene::Point3& given, const Enclosure3& exact);
scene::Measured relative_error(const scene::UnitVector3& given, const Enclosure3& exact);
scene::Measured relative_error(const scene::UnitVector3& given, const scene::UnitVector3& exact);

/// The tangent of the angle between two directions, an upper bound on the angle; infinite from 90
/// degrees on.
scene::Measured angle_error(const scene::UnitVector3& given, const Enclosure3& exact);

/// | |given| - 1 |, too large by at most the share kUnitDefectWidth; 0 is exact.
scene::Measured unit_defect(const scene::UnitVector3& given);
inline constexpr double kUnitDefectWidth = 0x1p-29;

/// The backward error of a root: the smallest relative change of the ray's and the sphere's doubles
/// that makes `parameter` an exact root, to first order.
/// Shape:  one ray, one sphere, one s (of either root, of either sign) -> one number.
/// Domain: that of ExactRay. Infinite if the parameter is not finite; otherwise at most
///         kMostBackwardError, since p is at most half of its divisor.
/// Error:  an upper bound, too large by at most the share kBackwardErrorWidth; 0 is exact.
/// Source: relative changes of at most e move p = |q|^2 - r^2, q = L + s d - C, by at most
///         e (2 sum_k |q_k| (|L_k| + |C_k| + |s d_k|) + 2 r^2) to first order. Therefore the e that
///         makes p vanish is |p| over this sum. There is no square root, so that the computation is
///         exact with enough bits, also at a tangent.
scene::Measured backward_error(const scene::Ray& ray, const scene::Sphere& sphere,
                               double parameter);
inline constexpr double kBackwardErrorWidth = 0x1p-29;
inline constexpr double kMostBackwardError = 0x1p52;

/// Lifts given doubles to enclosures, at a precision that keeps short products exact.
template <class Given>
Enclosure3 enclose_exactly(const Given& given) {
  constexpr int kBits = 192;
  return {Enclosure(given.x, kBits), Enclosure(given.y, kBits), Enclosure(given.z, kBits)};
}

/// An upper bound on |x|, in u; infinite if x has none.
scene::Measured in_units_of_u(const Enclosure& x);

}  // namespace raycheck::reference
