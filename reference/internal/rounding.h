#pragma once

// Computes narrow enclosures and correctly rounded doubles of a number that can be enclosed at any
// precision and compared exactly with rationals. Internal to reference/.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "reference/internal/kernels.h"
#include "scene/precision.h"

namespace raycheck::reference {

inline constexpr int kFirstBits = 128;

/// Narrows a first `enclosure`, about as narrow as enclose(kFirstBits), to the relative width
/// 2^-relative_bits. For x = 0 this would never end, so that `compare`, the exact sign of x -
/// rational, decides whether x is 0.
template <class Enclose, class Compare>
Enclosure narrow(Enclosure enclosure, int relative_bits, Enclose enclose, Compare compare) {
  bool known_nonzero = false;
  for (int bits = kFirstBits;;) {
    if (enclosure.contains_zero() && !known_nonzero) {
      if (enclosure.certain_sign() == 0) return enclosure;
      if (compare(Rational(0)) == 0) return Enclosure(0);
      known_nonzero = true;
    }
    if (enclosure.is_within(relative_bits)) return enclosure;
    bits *= 2;
    enclosure = enclose(bits);
  }
}

/// The midpoint of two neighbouring doubles; the neighbour above the largest is 2^1024.
inline Rational midpoint(double low, double high) {
  const auto exact = [](double value) {
    if (std::isfinite(value)) return Rational(value);
    const Rational beyond = Rational(std::ldexp(1.0, 1023)) * 2;
    return value > 0 ? beyond : Rational(-beyond);
  };
  return (exact(low) + exact(high)) / 2;
}

/// The double nearest to x, ties to even.
template <class Enclose, class Compare>
double round_to_nearest(Enclosure enclosure, Enclose enclose, Compare compare) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  bool known_nonzero = false;
  for (int bits = kFirstBits;;) {
    const double low = enclosure.lower_rounded();
    const double high = enclosure.upper_rounded();
    if (low == high) return low == 0 ? 0.0 : low;
    if (enclosure.contains_zero()) {
      if (!known_nonzero && compare(Rational(0)) == 0) return 0.0;
      known_nonzero = true;
    } else if (std::nextafter(low, kInfinity) == high) {
      const int side = compare(midpoint(low, high));
      if (side != 0) return side < 0 ? low : high;
      return (std::bit_cast<std::uint64_t>(low) & 1) == 0 ? low : high;
    }
    bits *= 2;
    enclosure = enclose(bits);
  }
}

/// The float nearest to x, ties to even, from the double nearest to x. Midpoints of two floats are
/// doubles. If the nearest double is not such a midpoint, it is on the same side of all midpoints
/// as x; otherwise `compare` decides.
template <class Compare>
double round_to_single(double nearest, Compare compare) {
  constexpr auto kSingle = scene::Precision::kSingle;
  const double rounded = scene::rounded_to(kSingle, nearest) + 0.0;  // no -0
  if (rounded == nearest) return rounded;
  // The neighbour of the largest float is 2^128, which rounds to infinity.
  const auto finite = [&](double x) {
    return std::isfinite(x) ? x : std::copysign(0x1p128, nearest);
  };
  const double other = scene::next_after(kSingle, rounded, nearest);
  if (nearest != finite(rounded) / 2 + finite(other) / 2) return rounded;
  const int side = compare(Rational(nearest));
  return side == 0 || (side > 0) == (rounded > nearest) ? rounded : other;
}

// Narrow and Round compute a value from a first enclosure, a function for narrower enclosures and
// the exact comparison. The relative width of the first enclosure must be 2^-relative_bits.

struct Narrow {
  int relative_bits;

  template <class Enclose, class Compare>
  Enclosure operator()(Enclosure first, Enclose enclose, Compare compare) const {
    return narrow(std::move(first), relative_bits, enclose, compare);
  }
};

struct Round {
  scene::Precision precision;
  static constexpr int relative_bits = 70;  ///< Enough to round nearly all values.

  template <class Enclose, class Compare>
  double operator()(Enclosure first, Enclose enclose, Compare compare) const {
    return (*this)(round_to_nearest(std::move(first), enclose, compare), compare);
  }
  /// Rounds a number, given the double nearest to it.
  template <class Compare>
  double operator()(double nearest, Compare compare) const {
    return precision == scene::Precision::kDouble ? nearest : round_to_single(nearest, compare);
  }
};

}  // namespace raycheck::reference
