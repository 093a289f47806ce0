// The decisions of `robust`, by the same code, in formats so small that their inputs are enumerated
// and every class that is certain is held against exact integers: that of the nearest root and that
// of the smaller one.
//
// A format of 8 bits has a sign, 2 bits of exponent and 5 of fraction, one of 10 bits 7 of
// fraction, as IEEE 754 has them but without infinities: 0, 1, ..., 63, then every second number to
// 126, every fourth to 252, and their negatives; or to 255, 510 and 1020. What is computed has the
// same 6 or 8 significant bits, and exponents that nothing overflows.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "fast/internal/robust_guess.h"
#include "tests/fast/small_float.h"

namespace raycheck::fast {
namespace {

using HWY_NAMESPACE::Ball;
using HWY_NAMESPACE::guess;
using HWY_NAMESPACE::Margins;

/// What the signs alone require where u = 2^-p <= 2^-6, without over- and underflow. Let U = 1 + u,
/// F = f|d|. T's coordinates are off by a share of u, so that
///   a^ <= U^3 a, (r^2)^ <= U r^2, (f^2)^ <= U^5 f^2, as many powers of 1 - u the other way,
///   |m^ - m| <= 1.155 (U^3 - U) F + u |m|, as the moment of absolute values is at most 1.155 F,
///   |b^ - b| <= (U^4 - 1) F.
/// Before its last rounding, which keeps the sign, far disc^ is then off by at most 5.2u a r^2
/// + 10.3u F^2, near disc^ by 10u a r^2 + 20u F^2 to first order, where 32u F^2 are required.
/// |disc^| > doubt^ leaves 8u (1-u)^6/U a r^2 + 16u (1-u)^10/U F^2, at least 7.1u a r^2
/// + 13.4u F^2, more than that. Where disc > 0 outside, b^2 > disc > 3u F^2 > (U^4 - 1)^2 F^2, so
/// b^ has b's sign. f^2 > r^2 as (1 + 8u)(1 - u)^2 > U^5, f^2 < r^2 as (1 - 8u) U^2 < (1 - u)^5.
template <int kBits>
struct Signs {
  static constexpr double kUnitRoundoff = 1 / static_cast<double>(std::int64_t{1} << kBits);
  static constexpr double kDiscriminantShare = 8 * kUnitRoundoff;
  static constexpr double kNearShare = 32 * kUnitRoundoff;
  static constexpr double kFarShare = 16 * kUnitRoundoff;
  static constexpr double kSurfaceShare = 8 * kUnitRoundoff;
  static constexpr double kReachShare = 0, kSmallShare = 0, kMostReach = 0;
  static constexpr double kLeastDiscriminant = 0x1p-60;
  static constexpr double kLargestSquare = 0x1p60;
};
static_assert(Margins<double>::kDiscriminantShare > Signs<53>::kDiscriminantShare &&
              Margins<double>::kNearShare > Signs<53>::kNearShare &&
              Margins<double>::kFarShare > Signs<53>::kFarShare &&
              Margins<double>::kSurfaceShare > Signs<53>::kSurfaceShare);

/// Inputs whose numbers are all those of the format up to these magnitudes, each with both roots.
/// Directions are taken up to reflections of the axes and factors of two, and in the plane z = 0
/// with y <= x, which their exchange makes all where centres and origins are as wide in y; origins,
/// centres and radii up to factors of two. None of these changes how anything is rounded.
struct Part {
  std::array<int, 3> origin, direction, centre;
  int radius;
};

struct Tally {
  std::int64_t inputs = 0, certain = 0, wrong = 0;

  double share() const { return static_cast<double>(certain) / static_cast<double>(inputs); }
};

/// The numbers of the format between two.
template <int kBits>
std::vector<int> numbers(int least, int most) {
  std::vector<int> result;
  for (int x = least; x <= most; ++x) {
    int odd = std::abs(x);
    while (odd >= 1 << kBits && odd % 2 == 0) odd /= 2;
    if (odd < 1 << kBits) result.push_back(x);
  }
  return result;
}

template <class Integer>
struct Point {
  Integer x, y, z;

  bool is_even() const { return x % 2 == 0 && y % 2 == 0 && z % 2 == 0; }
};

template <int kBits>
std::vector<Point<int>> points(const std::array<int, 3>& most, bool reflected) {
  std::vector<Point<int>> result;
  const auto along = [&](std::size_t k) {
    return numbers<kBits>(reflected ? 0 : -most[k], most[k]);
  };
  for (const int x : along(0)) {
    for (const int y : along(1)) {
      for (const int z : along(2)) result.push_back({x, y, z});
    }
  }
  return result;
}

template <int kBits>
std::vector<Point<int>> directions(const std::array<int, 3>& most) {
  std::vector<Point<int>> all = points<kBits>(most, true);
  std::erase_if(all,
                [&](const Point<int>& d) { return d.is_even() || (most[2] == 0 && d.y > d.x); });
  return all;
}

/// What is right of the radii of one guess, in integers.
struct Truth {
  bool is_tangent, nearest, smaller;

  Truth(const Point<std::int64_t>& T, const Point<std::int64_t>& d, std::int64_t radius) {
    const std::int64_t a = d.x * d.x + d.y * d.y + d.z * d.z;
    const std::int64_t b = T.x * d.x + T.y * d.y + T.z * d.z;
    const std::int64_t c = T.x * T.x + T.y * T.y + T.z * T.z - radius * radius;
    const std::int64_t discriminant = b * b - a * c;
    is_tangent = discriminant == 0;
    nearest = discriminant > 0 && (b >= 0 || c <= 0);
    smaller = discriminant > 0 && b >= 0 && c >= 0;
  }
};

/// The spheres about one centre and the rays from one origin.
template <int kBits, class Requirements>
void enumerate_from(const Point<int>& origin, const Point<int>& centre,
                    const std::vector<int>& radii, const std::vector<Point<int>>& ways,
                    Tally& tally) {
  using N = SmallFloat<kBits, Requirements>;
  const auto triple = [](const Point<int>& p) {
    return HWY_NAMESPACE::Triple<N>{N(p.x), N(p.y), N(p.z)};
  };
  const Point<std::int64_t> T = {centre.x - origin.x, centre.y - origin.y, centre.z - origin.z};
  for (std::size_t first = 0; first < radii.size(); first += kFloats) {
    const std::size_t count = std::min(kFloats, radii.size() - first);
    Floats radius{};
    for (std::size_t k = 0; k < count; ++k) radius[k] = static_cast<float>(radii[first + k]);
    const Ball<N> ball({triple(centre), N(radius)});
    for (const Point<int>& way : ways) {
      const HWY_NAMESPACE::RayOf<N> ray = {triple(origin), triple(way)};
      const auto nearest = guess(ray, ball, scene::Root::kNearest);
      const auto smaller = guess(ray, ball, scene::Root::kSmaller);
      for (std::size_t k = 0; k < count; ++k) {
        const Truth truth(T, {way.x, way.y, way.z}, radii[first + k]);
        const bool right = !truth.is_tangent && (nearest.hit.raw[k] != 0) == truth.nearest &&
                           (smaller.hit.raw[k] != 0) == truth.smaller;
        const bool certain = nearest.certain.raw[k] != 0;
        tally.certain += certain ? 1 : 0;
        tally.wrong += certain && !right ? 1 : 0;
      }
      tally.inputs += static_cast<std::int64_t>(count);
    }
  }
}

template <int kBits, class Requirements = Signs<kBits>>
Tally enumerate(const Part& part) {
  const std::vector<int> radii = numbers<kBits>(0, part.radius);
  std::vector<int> odd_radii = radii;
  std::erase_if(odd_radii, [](int radius) { return radius % 2 == 0; });
  const std::vector<Point<int>> ways = directions<kBits>(part.direction);
  Tally tally;
  for (const Point<int>& origin : points<kBits>(part.origin, false)) {
    for (const Point<int>& centre : points<kBits>(part.centre, false)) {
      const bool halved = origin.is_even() && centre.is_even();
      enumerate_from<kBits, Requirements>(origin, centre, halved ? odd_radii : radii, ways, tally);
    }
  }
  return tally;
}

/// A part, how many inputs it has and how many of these are certain.
struct Enumerated {
  Part part;
  std::int64_t inputs;
  double least_share;
};

template <int kBits>
void expect_no_wrong_class(const std::vector<Enumerated>& parts) {
  for (const auto& [part, inputs, least_share] : parts) {
    const Tally tally = enumerate<kBits>(part);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_EQ(tally.inputs, inputs);
    EXPECT_GE(tally.share(), least_share);
  }
}

/// 607,727,871 inputs: in the plane every centre and radius with directions up to 12, every
/// direction with centres and radii up to 20, far origins, whose differences to centres are
/// rounded; and in space all numbers up to 10.
TEST(SmallFormats, HaveNoWrongClassIn8Bits) {
  expect_no_wrong_class<6>({
      {{{0, 0, 0}, {12, 12, 0}, {252, 252, 0}, 252}, 303724512, 0.68},
      {{{0, 0, 0}, {252, 252, 0}, {20, 20, 0}, 20}, 109620000, 0.61},
      {{{252, 3, 0}, {3, 3, 0}, {252, 0, 0}, 31}, 89701584, 0.43},
      {{{0, 0, 0}, {10, 10, 10}, {10, 10, 10}, 10}, 104681775, 0.67},
  });
}

/// 478,090,863 inputs, of the same kinds: in the plane every centre near the x axis and every
/// radius; every direction; far origins; and space.
TEST(SmallFormats, HaveNoWrongClassIn10Bits) {
  expect_no_wrong_class<8>({
      {{{0, 0, 0}, {6, 6, 0}, {1020, 15, 0}, 1020}, 212744448, 0.87},
      {{{0, 0, 0}, {1020, 1020, 0}, {6, 6, 0}, 6}, 56661696, 0.86},
      {{{1020, 1, 0}, {2, 2, 0}, {7, 1, 0}, 255}, 104002944, 0.82},
      {{{0, 0, 0}, {10, 10, 10}, {10, 10, 10}, 10}, 104681775, 0.90},
  });
}

/// All 17,355,686,400 inputs in the plane with the origin at 0.
TEST(LongSmallFormats, HaveNoWrongClassInThePlaneIn8Bits) {
  expect_no_wrong_class<6>({{{{0, 0, 0}, {252, 252, 0}, {252, 252, 0}, 252}, 17355686400, 0.67}});
}

template <int kBits>
struct WithoutDoubt : Signs<kBits> {
  static constexpr double kDiscriminantShare = 0, kFarShare = 0;
};
template <int kBits>
struct WithAnEighthOfTheDoubt : Signs<kBits> {
  static constexpr double kDiscriminantShare = Signs<kBits>::kDiscriminantShare / 8;
  static constexpr double kFarShare = Signs<kBits>::kFarShare / 8;
};
template <int kBits>
struct WithoutNearDoubt : Signs<kBits> {
  static constexpr double kNearShare = 0;
};
template <int kBits>
struct WithoutFarDoubt : Signs<kBits> {
  static constexpr double kFarShare = 0;
};
template <int kBits>
struct WithFarDoubtOfTheOtherSign : Signs<kBits> {
  static constexpr double kFarShare = -Signs<kBits>::kFarShare;
};
template <int kBits>
struct WithoutSurface : Signs<kBits> {
  static constexpr double kSurfaceShare = 0;
};
template <int kBits>
struct WithSurfaceOfTheOtherSign : Signs<kBits> {
  static constexpr double kSurfaceShare = -Signs<kBits>::kSurfaceShare;
};

/// Margins that are too small are seen in both formats.
TEST(SmallFormats, HaveWrongClassesByMutants) {
  const Part in_8_bits = {{0, 0, 0}, {7, 7, 0}, {63, 63, 0}, 31};
  EXPECT_GT((enumerate<6, WithoutDoubt<6>>(in_8_bits).wrong), 0);
  EXPECT_GT((enumerate<6, WithAnEighthOfTheDoubt<6>>(in_8_bits).wrong), 0);
  EXPECT_GT((enumerate<6, WithoutNearDoubt<6>>(in_8_bits).wrong), 0);
  EXPECT_GT((enumerate<6, WithoutFarDoubt<6>>(in_8_bits).wrong), 0);
  EXPECT_GT((enumerate<6, WithFarDoubtOfTheOtherSign<6>>(in_8_bits).wrong), 0);
  EXPECT_GT((enumerate<6, WithoutSurface<6>>(in_8_bits).wrong), 0);
  EXPECT_GT((enumerate<6, WithSurfaceOfTheOtherSign<6>>(in_8_bits).wrong), 0);
  const Part in_10_bits = {{0, 0, 0}, {4, 4, 0}, {255, 7, 0}, 255};
  EXPECT_GT((enumerate<8, WithoutDoubt<8>>(in_10_bits).wrong), 0);
  EXPECT_GT((enumerate<8, WithAnEighthOfTheDoubt<8>>(in_10_bits).wrong), 0);
  EXPECT_GT((enumerate<8, WithoutNearDoubt<8>>(in_10_bits).wrong), 0);
  EXPECT_GT((enumerate<8, WithFarDoubtOfTheOtherSign<8>>(in_10_bits).wrong), 0);
  EXPECT_GT((enumerate<8, WithSurfaceOfTheOtherSign<8>>(in_10_bits).wrong), 0);
}

/// Against doubles, in which sums and products of such numbers are exact, and quotients and roots
/// nowhere so near a tie that rounding twice matters.
TEST(SmallFormats, AreRoundedToNearestAndTiesToEven) {
  using N = SmallFloat<6, Signs<6>>;
  const auto rounded = [](double x) {
    if (x == 0) return x;
    const int shift = 5 - std::ilogb(x);
    return std::ldexp(std::nearbyint(std::ldexp(x, shift)), -shift);
  };
  for (const int x : numbers<6>(-252, 252)) {
    for (const int y : numbers<6>(1, 252)) {
      EXPECT_EQ((N(x) + N(y)).raw[0], rounded(x + y));
      EXPECT_EQ((N(x) - N(y)).raw[0], rounded(x - y));
      EXPECT_EQ((N(x) * N(y)).raw[0], rounded(x * y));
      EXPECT_EQ((N(x) / N(y)).raw[0], rounded(static_cast<double>(x) / y));
      EXPECT_EQ(sqrt(N(y)).raw[0], rounded(std::sqrt(y)));
    }
  }
}

}  // namespace
}  // namespace raycheck::fast
