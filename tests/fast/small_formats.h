#pragma once
#include "tests/standard.h"

// Inputs in formats with few bits, the margins of the formulas, and the right answers by integers.

namespace raycheck::fast {

/// The margins for certain signs if u = 2^-p <= 2^-6, without over- and underflow. Let U = 1 + u, F
/// = f|d|. T's coordinates are off by a share of u, so that
///   a^ <= U^3 a, (r^2)^ <= U r^2, (f^2)^ <= U^5 f^2, as many powers of 1 - u the other way,
///   |m^ - m| <= 1.155 (U^3 - U) F + u |m|, as the moment of absolute values is at most 1.155 F,
///   |b^ - b| <= (U^4 - 1) F.
/// Before its last rounding, which keeps the sign, far disc^ is then off by at most 5.2u a r^2
/// + 10.3u F^2, near disc^ by 10u a r^2 + 20u F^2 to first order, where 32u F^2 are required.
/// |disc^| > doubt^ leaves 8u (1-u)^6/U a r^2 + 16u (1-u)^10/U F^2, at least 7.1u a r^2
/// + 13.4u F^2, which is more. If disc > 0 and the origin is outside, b^2 > disc > 3u F^2 > (U^4 -
/// 1)^2 F^2, so that b^ has b's sign. f^2 > r^2, since (1 + 8u)(1 - u)^2 > U^5; f^2 < r^2, since (1
/// - 8u) U^2 < (1 - u)^5.
enum class Margin : std::size_t {
  kRight,
  kNoDoubt,
  kAnEighthOfTheDoubt,
  kNoNearDoubt,
  kNoFarDoubt,
  kFarDoubtOfTheOtherSign,
  kNoSurface,
  kSurfaceOfTheOtherSign
};
inline constexpr std::size_t kMarginCount = 8;

/// The margins; kMargin selects one that is too small, if any.
template <int kBits, Margin kMargin = Margin::kRight>
struct Signs {
  static constexpr double kUnitRoundoff = 1 / static_cast<double>(std::int64_t{1} << kBits);
  static constexpr double kDoubt = kMargin == Margin::kNoDoubt              ? 0
                                   : kMargin == Margin::kAnEighthOfTheDoubt ? 0.125
                                                                            : 1;
  static constexpr double kDiscriminantShare = 8 * kUnitRoundoff * kDoubt;
  static constexpr double kNearShare = kMargin == Margin::kNoNearDoubt ? 0 : 32 * kUnitRoundoff;
  static constexpr double kFarShare = kMargin == Margin::kNoFarDoubt ? 0
                                      : kMargin == Margin::kFarDoubtOfTheOtherSign
                                          ? -16 * kUnitRoundoff
                                          : 16 * kUnitRoundoff * kDoubt;
  static constexpr double kSurfaceShare = kMargin == Margin::kNoSurface ? 0
                                          : kMargin == Margin::kSurfaceOfTheOtherSign
                                              ? -8 * kUnitRoundoff
                                              : 8 * kUnitRoundoff;
  static constexpr double kReachShare = 0, kSmallShare = 0, kMostReach = 0;
  static constexpr double kLeastDiscriminant = 0x1p-60;
  static constexpr double kLargestSquare = 0x1p60;
};

/// Inputs with all numbers of the format up to these magnitudes, each with both roots. Of
/// directions that differ by reflections of the axes and factors of two, one is taken. In the plane
/// z = 0 only directions with y <= x are taken; exchanging x and y gives the others if centres and
/// origins are as wide in y. Of origins, centres and radii that differ by a factor of two, one is
/// taken. None of these changes affects rounding.
struct Part {
  std::array<int, 3> origin, direction, centre;
  int radius;
  std::size_t slice = 0, slices = 1;  ///< Every slices-th direction, from direction `slice` on.
};

struct Tally {
  std::int64_t inputs = 0, certain = 0, wrong = 0;

  double share() const { return static_cast<double>(certain) / static_cast<double>(inputs); }
};

/// The number of numbers >= 0 in a format of 10 bits.
inline constexpr std::size_t kMostNumbers = 512;

/// The numbers of the format from `least` to `most`.
inline std::vector<int> numbers(int bits, int least, int most) {
  std::vector<int> result;
  for (int x = least; x <= most; ++x) {
    int odd = std::abs(x);
    while (odd >= 1 << bits && odd % 2 == 0) odd /= 2;
    if (odd < 1 << bits) result.push_back(x);
  }
  return result;
}

template <class Integer>
struct Point {
  Integer x, y, z;

  bool is_even() const { return x % 2 == 0 && y % 2 == 0 && z % 2 == 0; }
};

inline std::vector<Point<int>> points(int bits, const std::array<int, 3>& most, bool reflected) {
  std::vector<Point<int>> result;
  const auto along = [&](std::size_t k) {
    return numbers(bits, reflected ? 0 : -most[k], most[k]);
  };
  for (const int x : along(0)) {
    for (const int y : along(1)) {
      for (const int z : along(2)) result.push_back({x, y, z});
    }
  }
  return result;
}

inline std::vector<Point<int>> directions(int bits, const Part& part) {
  std::vector<Point<int>> all = points(bits, part.direction, true);
  std::erase_if(all, [&](const Point<int>& d) {
    return d.is_even() || (part.direction[2] == 0 && d.y > d.x);
  });
  std::size_t k = 0;
  std::erase_if(all, [&](const Point<int>&) { return k++ % part.slices != part.slice; });
  return all;
}

/// The class of every radius for a line, in integers. With m = a |T|^2 - b^2, the discriminant a
/// r^2 - m is positive if r^2 > m/a, that is, if r^2 is above the integer part of the quotient.
struct Truth {
  std::int32_t most_missed, tangent,
      distance_sq;     ///< Values of r^2; `tangent` is -1 if no radius is tangent.
  std::int32_t ahead;  ///< -1 if b >= 0, otherwise 0.

  Truth(const Point<std::int64_t>& T, const Point<std::int64_t>& d) {
    const std::int64_t a = d.x * d.x + d.y * d.y + d.z * d.z;
    const std::int64_t b = T.x * d.x + T.y * d.y + T.z * d.z;
    const std::int64_t T_sq = T.x * T.x + T.y * T.y + T.z * T.z, m = a * T_sq - b * b;
    most_missed = static_cast<std::int32_t>(m / a);
    tangent = m % a == 0 ? most_missed : -1;
    distance_sq = static_cast<std::int32_t>(T_sq);
    ahead = b >= 0 ? -1 : 0;
  }
};

}  // namespace raycheck::fast
