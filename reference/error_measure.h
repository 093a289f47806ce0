#pragma once

#include "reference/enclosure.h"
#include "scene/geometry.h"
#include "scene/precision.h"

namespace raycheck::reference {

// The errors of given doubles against enclosed exact values. Every result is an upper bound, as
// sharp as the enclosure is narrow, in u of doubles unless in ulp; infinite for a given value that
// is not finite, or that is not 0 when the exact one is.

/// |given - exact| / ulp(exact), ulp(x) the gap between the numbers of the format around x.
scene::Measured ulp_error(double given, const Enclosure& exact,
                          scene::Precision precision = scene::Precision::kDouble);

/// |given - exact| / |exact|
scene::Measured relative_error(const scene::Point3& given, const Enclosure3& exact);
scene::Measured relative_error(const scene::UnitVector3& given, const Enclosure3& exact);
scene::Measured relative_error(const scene::UnitVector3& given, const scene::UnitVector3& exact);

/// The angle between two directions (as its tangent, which is at least as large; infinite from 90
/// degrees on).
scene::Measured angle_error(const scene::UnitVector3& given, const Enclosure3& exact);

/// | |given| - 1 |, too large by at most kUnitDefectWidth relatively; 0 is exact.
scene::Measured unit_defect(const scene::UnitVector3& given);
inline constexpr double kUnitDefectWidth = 0x1p-29;

/// Backward error of a root: the smallest relative change of the ray's and the sphere's doubles
/// that makes `parameter` an exact root, to first order.
/// Shape:  one ray, one sphere, one s (of either root, of either sign) -> one number.
/// Domain: as ExactRay; infinite for a parameter that is not finite, else at most
///         kMostBackwardError: p is at most half of its divisor.
/// Error:  an upper bound, too large by at most kBackwardErrorWidth relatively; 0 is exact.
/// Source: relative changes of at most e move p = |q|^2 - r^2, q = L + s d - C, by at most
///         e (2 sum_k |q_k| (|L_k| + |C_k| + |s d_k|) + 2 r^2) to first order, so that the e that
///         makes p vanish is |p| over that sum. No square root occurs: all of it is exact in enough
///         bits, at a tangent too.
scene::Measured backward_error(const scene::Ray& ray, const scene::Sphere& sphere,
                               double parameter);
inline constexpr double kBackwardErrorWidth = 0x1p-29;
inline constexpr double kMostBackwardError = 0x1p52;

/// An enclosure of the given doubles themselves, at a precision that keeps short products exact.
template <class Given>
Enclosure3 enclose_exactly(const Given& given) {
  constexpr int kBits = 192;
  return {Enclosure(given.x, kBits), Enclosure(given.y, kBits), Enclosure(given.z, kBits)};
}

/// An upper bound of |x|; infinite when it is not finite.
scene::Measured in_units_of_u(const Enclosure& x);

}  // namespace raycheck::reference
