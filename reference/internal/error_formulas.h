#pragma once

// The formulas of reference/error_measure.h and reference/ray_error.h for all number types, and the
// stage of double-doubles before that of balls. Internal to reference/.

#include <cmath>
#include <limits>
#include <optional>

#include "reference/internal/kernels.h"
#include "scene/precision.h"

namespace raycheck::reference {

/// |given - exact| / |exact|
template <class Number>
Number relative_distance(const Triple<Number>& given, const Triple<Number>& exact) {
  return norm(given - exact) / norm(exact);
}

/// The tangent of the angle between two directions. The exact one is unit; the cosine is given.
template <class Number>
Number tangent(const Triple<Number>& given, const Triple<Number>& exact, const Number& cosine) {
  return norm(cross(given, exact)) / cosine;
}

/// | |given| - 1 |
template <class Number>
Number distance_from_unit(const Triple<Number>& given) {
  return abs(norm(given) - Number(1));
}

/// | |point - centre| - radius | / radius
template <class Number>
Number distance_from_sphere(const Triple<Number>& point, const Triple<Number>& centre,
                            const Number& radius) {
  return abs(norm(point - centre) - radius) / radius;
}

/// |along x D| / |along|
template <class Number>
Number distance_from_line(const Triple<Number>& along, const Triple<Number>& direction) {
  return norm(cross(along, direction)) / norm(along);
}

template <class Given>
Triple<DoubleDouble> in_double_doubles(const Given& given) {
  return {DoubleDouble(given.x), DoubleDouble(given.y), DoubleDouble(given.z)};
}

/// An error from double-doubles is used if the relative width of its enclosure is at most this. The
/// bound is then too large by at most twice this share.
inline constexpr double kErrorWidth = 0x1p-30;

/// An upper bound on an error >= 0, in multiples of 2^exponent; empty if its enclosure is too wide.
inline std::optional<double> narrow_error(const DoubleDouble& error, int exponent) {
  const double upper = error.upper();
  const double bound = std::ldexp(upper, -exponent);
  const bool is_narrow = error.radius() <= kErrorWidth * upper;
  return is_narrow && std::isfinite(bound) ? std::optional(bound) : std::nullopt;
}

/// An upper bound on an error >= 0, in u of doubles; empty if its enclosure is too wide.
inline std::optional<scene::Measured> narrow_error_in_u(const DoubleDouble& error) {
  const auto bound = narrow_error(error, -std::numeric_limits<double>::digits);
  return bound ? std::optional(scene::Measured{*bound}) : std::nullopt;
}

}  // namespace raycheck::reference
