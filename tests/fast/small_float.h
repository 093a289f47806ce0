// Numbers with few significant bits, for formulas that are templates over their number type.
// Compiled once for each of Highway's targets (fast/internal/lanes.h).

#if defined(RAYCHECK_TESTS_FAST_SMALL_FLOAT_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_TESTS_FAST_SMALL_FLOAT_H_
#undef RAYCHECK_TESTS_FAST_SMALL_FLOAT_H_
#else
#define RAYCHECK_TESTS_FAST_SMALL_FLOAT_H_
#endif

#include "fast/internal/robust_guess.h"
#include "tests/standard.h"

#pragma GCC diagnostic ignored "-Wpsabi"  // No other file is passed such numbers.

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

inline constexpr std::size_t kFloats = HWY_TARGET == HWY_AVX2 ? 8 : 4;
using Floats __attribute__((vector_size(4 * kFloats))) = float;
using Truths __attribute__((vector_size(4 * kFloats))) = std::int32_t;  // 0 or -1 each

struct SmallMask {
  Truths raw;

  friend SmallMask operator&(SmallMask a, SmallMask b) { return {a.raw & b.raw}; }
  friend SmallMask operator|(SmallMask a, SmallMask b) { return {a.raw | b.raw}; }
  friend SmallMask operator!(SmallMask a) { return {~a.raw}; }
  friend bool all(SmallMask a) { return !any(!a); }
  friend bool any(SmallMask a) {
    std::int32_t some = 0;
    for (std::size_t k = 0; k < kFloats; ++k) some |= a.raw[k];
    return some != 0;
  }
};

/// kFloats numbers with p = kBits significand bits, in the range of floats. Every operation is
/// rounded once, to nearest and ties to even: the 24 bits of a float are at least 2p + 2, so that
/// rounding the float result again gives the rounded exact result (Figueroa, When is double
/// rounding innocuous?, 1995, for +, -, *, / and square roots). Domain: no subnormal results.
template <int kBits, class Requirements>
struct SmallFloat {
  static_assert(2 * kBits + 2 <= std::numeric_limits<float>::digits);
  Floats raw;

  SmallFloat() = default;
  explicit SmallFloat(Floats exact)
      : raw(reinterpret_cast<Floats>(rounded_bits(reinterpret_cast<Truths>(exact)))) {}
  explicit SmallFloat(double x) : raw(Floats{} + rounded(static_cast<float>(x))) {}

  friend SmallFloat operator+(SmallFloat a, SmallFloat b) { return SmallFloat(a.raw + b.raw); }
  friend SmallFloat operator-(SmallFloat a, SmallFloat b) { return SmallFloat(a.raw - b.raw); }
  friend SmallFloat operator*(SmallFloat a, SmallFloat b) { return SmallFloat(a.raw * b.raw); }
  friend SmallFloat operator/(SmallFloat a, SmallFloat b) { return SmallFloat(a.raw / b.raw); }
  friend SmallFloat operator-(SmallFloat a) { return SmallFloat(-a.raw); }
  // Not fused, since the float of a fused result would be rounded twice.
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

 private:
  template <class Bits>
  static constexpr Bits rounded_bits(Bits exact) {
    constexpr int kDropped = std::numeric_limits<float>::digits - kBits;
    return (exact + (((exact >> kDropped) & 1) + ((1 << (kDropped - 1)) - 1))) & -(1 << kDropped);
  }
  static constexpr float rounded(float exact) {
    return std::bit_cast<float>(rounded_bits(std::bit_cast<std::int32_t>(exact)));
  }
};

/// The margins that guess() requires for these numbers.
template <int kBits, class Requirements>
struct Margins<SmallFloat<kBits, Requirements>> : Requirements {};

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_TESTS_FAST_SMALL_FLOAT_H_
