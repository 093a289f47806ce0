#pragma once

// Errors in double-doubles: the stage before that of balls.

#include <cmath>
#include <limits>
#include <optional>

#include "reference/internal/double_double.h"
#include "scene/precision.h"

namespace raycheck::reference {

/// |given - exact| / |exact|
template <class Number>
Number relative_distance(const Triple<Number>& given, const Triple<Number>& exact) {
  return norm(given - exact) / norm(exact);
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

/// The error relative_error() of reference/error_measure.h.
template <class Given>
std::optional<scene::Measured> near_relative_error(const Given& given,
                                                   const Triple<DoubleDouble>& exact) {
  return by_double_doubles(
      [&] { return narrow_error_in_u(relative_distance(in_double_doubles(given), exact)); });
}

/// The largest share by which such a bound is above the error.
inline constexpr double kNearErrorShare = 2 * kErrorWidth;

}  // namespace raycheck::reference
