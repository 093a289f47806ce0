#pragma once

// The numbers that tests of reference/ compute with: MPFR, which is precise enough for the literal
// formulas and independent of reference/'s arithmetic.

#include <boost/multiprecision/mpfr.hpp>

#include "reference/enclosure.h"
#include "tests/numbers.h"
#include "tests/standard.h"

namespace raycheck::reference {

/// About 6600 bits. The exact square of a sum of doubles of all magnitudes needs half of them; the
/// other half is for quotients and roots.
using Big = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<2000>,
                                          boost::multiprecision::et_off>;

inline Big power_of_two(int exponent) { return ldexp(Big(1), exponent); }

/// Halfway from `value` to the next double on the side of `towards` (an infinity). The double
/// beyond the largest counts as 2^1024.
inline Big halfway(double value, double towards) {
  const auto real = [](double x) {
    if (std::isfinite(x)) return Big(x);
    return x > 0 ? power_of_two(1024) : Big(-power_of_two(1024));
  };
  return (real(value) + real(std::nextafter(value, towards))) / 2;
}

/// Whether `value` is the double nearest to x: ties to even, overflow to infinity.
inline bool is_nearest(double value, const Big& x) {
  if (std::isnan(value)) return false;
  const bool even = std::bit_cast<std::uint64_t>(value) % 2 == 0;
  if (value != -kInfinity) {
    const Big low = halfway(value, -kInfinity);
    if (even ? x < low : x <= low) return false;
  }
  if (value != kInfinity) {
    const Big high = halfway(value, kInfinity);
    if (even ? x > high : x >= high) return false;
  }
  return true;
}

/// Whether the enclosure contains x. x has the rounding errors of a few operations on doubles of
/// any size, which are far below the width of an enclosure.
inline bool contains(const Enclosure& enclosure, const Big& x) {
  const Big error = abs(x) * power_of_two(-6000) + power_of_two(-4300);
  Enclosure truth(0, 8000);
  Enclosure margin(0, 64);
  arf_set_mpfr(arb_midref(truth.ball()), x.backend().data());
  arf_set_mpfr(arb_midref(margin.ball()), error.backend().data());
  arb_add_error(truth.ball(), margin.ball());
  return arb_overlaps(enclosure.ball(), truth.ball()) != 0;
}

struct Big3 {
  Big x, y, z;
};
template <class Triple>
Big3 big(const Triple& v) {
  return {Big(v.x), Big(v.y), Big(v.z)};
}
inline Big3 operator+(const Big3& a, const Big3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Big3 operator-(const Big3& a, const Big3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Big3 operator*(const Big& s, const Big3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Big3 operator/(const Big3& a, const Big& s) { return {a.x / s, a.y / s, a.z / s}; }
inline Big dot(const Big3& a, const Big3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Big3 cross(const Big3& a, const Big3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Big norm(const Big3& a) { return sqrt(dot(a, a)); }

template <class Triple>
bool is_nearest(const Triple& value, const Big3& x) {
  return is_nearest(value.x, x.x) && is_nearest(value.y, x.y) && is_nearest(value.z, x.z);
}
inline bool contains(const Enclosure3& enclosure, const Big3& x) {
  return contains(enclosure.x, x.x) && contains(enclosure.y, x.y) && contains(enclosure.z, x.z);
}

}  // namespace raycheck::reference
