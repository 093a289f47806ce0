#pragma once

// Numbers of few significant bits, for formulas that are templates over their number.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "fast/internal/robust_guess.h"

namespace raycheck::fast {

inline constexpr std::size_t kFloats = 4;
using Floats __attribute__((vector_size(16))) = float;
using Truths __attribute__((vector_size(16))) = std::int32_t;  // 0 or -1 each

struct SmallMask {
  Truths raw;

  friend SmallMask operator&(SmallMask a, SmallMask b) { return {a.raw & b.raw}; }
  friend SmallMask operator|(SmallMask a, SmallMask b) { return {a.raw | b.raw}; }
  friend SmallMask operator!(SmallMask a) { return {~a.raw}; }
  friend bool all(SmallMask a) { return !any(!a); }
  friend bool any(SmallMask a) { return ((a.raw[0] | a.raw[1]) | (a.raw[2] | a.raw[3])) != 0; }
};

/// Numbers of so many significand bits, four side by side, in the range of floats. Every operation
/// is rounded once, to nearest and ties to even: a float's 24 bits are at least 2p + 2, so that
/// rounding the float's result again rounds the exact one (Figueroa, When is double rounding
/// innocuous?, 1995, for +, -, *, / and square roots). Domain: no subnormal results.
template <int kBits, class Requirements>
struct SmallFloat {
  static_assert(2 * kBits + 2 <= std::numeric_limits<float>::digits);
  Floats raw;

  SmallFloat() = default;
  explicit SmallFloat(Floats exact) {
    constexpr int kDropped = std::numeric_limits<float>::digits - kBits;
    const auto bits = reinterpret_cast<Truths>(exact);
    const Truths half = ((bits >> kDropped) & 1) + ((1 << (kDropped - 1)) - 1);
    raw = reinterpret_cast<Floats>((bits + half) & -(1 << kDropped));
  }
  explicit SmallFloat(double x) : SmallFloat(Floats{} + static_cast<float>(x)) {}

  friend SmallFloat operator+(SmallFloat a, SmallFloat b) { return SmallFloat(a.raw + b.raw); }
  friend SmallFloat operator-(SmallFloat a, SmallFloat b) { return SmallFloat(a.raw - b.raw); }
  friend SmallFloat operator*(SmallFloat a, SmallFloat b) { return SmallFloat(a.raw * b.raw); }
  friend SmallFloat operator/(SmallFloat a, SmallFloat b) { return SmallFloat(a.raw / b.raw); }
  friend SmallFloat operator-(SmallFloat a) { return SmallFloat(-a.raw); }
  // Not fused: the float of a fused result would be rounded twice.
  friend SmallFloat mul_add(SmallFloat a, SmallFloat b, SmallFloat c) { return a * b + c; }
  friend SmallFloat mul_sub(SmallFloat a, SmallFloat b, SmallFloat c) { return a * b - c; }
  friend SmallFloat sqrt(SmallFloat a) {
    Floats root;
    for (std::size_t k = 0; k < kFloats; ++k) root[k] = std::sqrt(a.raw[k]);
    return SmallFloat(root);
  }
  friend SmallMask operator<(SmallFloat a, SmallFloat b) { return {a.raw < b.raw}; }
  friend SmallMask operator>(SmallFloat a, SmallFloat b) { return {a.raw > b.raw}; }
  friend SmallFloat select(SmallMask condition, SmallFloat yes, SmallFloat no) {
    return SmallFloat(
        reinterpret_cast<Floats>((condition.raw & reinterpret_cast<Truths>(yes.raw)) |
                                 (~condition.raw & reinterpret_cast<Truths>(no.raw))));
  }
  friend SmallFloat smaller(SmallFloat a, SmallFloat b) { return select(a < b, a, b); }
  friend SmallFloat larger(SmallFloat a, SmallFloat b) { return select(a > b, a, b); }
  friend SmallFloat absolute(SmallFloat a) {
    return SmallFloat(reinterpret_cast<Floats>(reinterpret_cast<Truths>(a.raw) & 0x7fffffff));
  }
};

/// What guess() requires of these numbers.
template <int kBits, class Requirements>
struct HWY_NAMESPACE::Margins<SmallFloat<kBits, Requirements>> : Requirements {};

}  // namespace raycheck::fast
