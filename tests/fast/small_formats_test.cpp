// Tests the decisions of `robust`, by the same code, in formats so small that all inputs are
// enumerated. Every certain hit class is compared with exact integers, for the nearest and for the
// smaller root.
//
// A format of 8 bits has a sign, 2 bits of exponent and 5 bits of fraction, as in IEEE 754, but no
// infinities. Its numbers are 0, 1, ..., 63, then every second number to 126, every fourth to 252,
// and their negatives. A format of 10 bits has 7 bits of fraction, and its numbers go to 255, 510
// and 1020. Results have the same 6 or 8 significant bits, and exponents that do not overflow.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/fast/small_formats_test.cpp"
// AVX2 halves the time of the baseline. Compiling for more targets would take longer than they
// save.
#define HWY_DISABLED_TARGETS (~(HWY_AVX2 | HWY_BASELINE_TARGETS))
#include "tests/fast/small_formats.h"

#include <hwy/foreach_target.h>

#include "fast/internal/robust_guess.h"
#include "tests/fast/small_float.h"
#include "tests/testing.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

/// Enumerates the spheres about one centre and the rays from one origin. The inner loop is over
/// radii; terms that do not depend on them are computed once for each ray.
template <int kBits, class Requirements>
void enumerate_from(const Point<int>& origin, const Point<int>& centre,
                    const std::vector<int>& radii, const std::vector<Point<int>>& ways,
                    Tally& tally) {
  using N = SmallFloat<kBits, Requirements>;
  const auto triple = [](const Point<int>& p) { return Triple<N>{N(p.x), N(p.y), N(p.z)}; };
  const Ball<N> any({triple(centre), N(1)});
  struct Radii {
    N square, doubt, inside, outside;
    Truths whole, is_one;
  };
  std::array<Radii, kMostNumbers / kFloats> all;  // std::vector might not align them.
  std::size_t groups = 0;
  for (std::size_t first = 0; first < radii.size(); first += kFloats) {
    Floats radius{};
    Truths whole{}, is_one{};
    for (std::size_t k = 0; k < std::min(kFloats, radii.size() - first); ++k) {
      radius[k] = static_cast<float>(radii[first + k]);
      whole[k] = radii[first + k] * radii[first + k];
      is_one[k] = -1;
    }
    const Ball<N> ball({triple(centre), N(radius)});
    all.at(groups++) = {ball.square, ball.doubt, ball.inside, ball.outside, whole, is_one};
  }
  const Point<std::int64_t> T = {centre.x - origin.x, centre.y - origin.y, centre.z - origin.z};
  for (const Point<int>& way : ways) {
    const RayOf<N> ray = {triple(origin), triple(way)};
    const Truth truth(T, {way.x, way.y, way.z});
    Truths certain{}, wrong{};  // sums of -1
    for (const auto& [square, doubt, inside, outside, whole, is_one] :
         std::span(all.data(), groups)) {
      Ball<N> ball = any;  // stays in registers
      std::tie(ball.square, ball.doubt, ball.inside, ball.outside) =
          std::tie(square, doubt, inside, outside);
      const auto nearest = guess(ray, ball, scene::Root::kNearest);
      const auto smaller = guess(ray, ball, scene::Root::kSmaller);
      const Truths is_met = whole > truth.most_missed;
      const Truths is_nearest = is_met & (truth.ahead | (whole >= truth.distance_sq));
      const Truths is_smaller = is_met & truth.ahead & (whole <= truth.distance_sq);
      const Truths is_certain = nearest.certain.raw & is_one;
      certain += is_certain;
      wrong += is_certain & ((whole == truth.tangent) | (nearest.hit.raw ^ is_nearest) |
                             (smaller.hit.raw ^ is_smaller));
    }
    for (std::size_t k = 0; k < kFloats; ++k) {
      tally.certain -= certain[k];
      tally.wrong -= wrong[k];
    }
  }
  tally.inputs += static_cast<std::int64_t>(radii.size() * ways.size());
}

template <int kBits, class Requirements>
Tally enumerate(const Part& part) {
  const std::vector<int> radii = numbers(kBits, 0, part.radius);
  std::vector<int> odd_radii = radii;
  std::erase_if(odd_radii, [](int radius) { return radius % 2 == 0; });
  const std::vector<Point<int>> ways = directions(kBits, part);
  Tally tally;
  for (const Point<int>& origin : points(kBits, part.origin, false)) {
    for (const Point<int>& centre : points(kBits, part.centre, false)) {
      const bool halved = origin.is_even() && centre.is_even();
      enumerate_from<kBits, Requirements>(origin, centre, halved ? odd_radii : radii, ways, tally);
    }
  }
  return tally;
}

using Enumerate = Tally (*)(const Part&);
template <int kBits, std::size_t... kMargins>
constexpr std::array<Enumerate, kMarginCount> by_margin(std::index_sequence<kMargins...>) {
  return {enumerate<kBits, Signs<kBits, Margin{kMargins}>>...};
}

Tally enumerate_in(int bits, Margin margin, const Part& part) {
  constexpr std::make_index_sequence<kMarginCount> kAll;
  constexpr auto kIn6 = by_margin<6>(kAll), kIn8 = by_margin<8>(kAll);
  return (bits == 6 ? kIn6 : kIn8).at(static_cast<std::size_t>(margin))(part);
}

/// Compares with doubles. In doubles, sums and products of such numbers are exact, and quotients
/// and roots are not so near a tie that rounding twice matters.
void expect_rounded() {
  using N = SmallFloat<6, Signs<6>>;
  const auto rounded = [](double x) {
    if (x == 0) return x;
    const int shift = 5 - std::ilogb(x);
    return std::ldexp(std::nearbyint(std::ldexp(x, shift)), -shift);
  };
  for (const int x : numbers(6, -252, 252)) {
    for (const int y : numbers(6, 1, 252)) {
      EXPECT_EQ((N(x) + N(y)).raw[0], rounded(x + y));
      EXPECT_EQ((N(x) - N(y)).raw[0], rounded(x - y));
      EXPECT_EQ((N(x) * N(y)).raw[0], rounded(x * y));
      EXPECT_EQ((N(x) / N(y)).raw[0], rounded(static_cast<double>(x) / y));
      EXPECT_EQ(sqrt(N(y)).raw[0], rounded(std::sqrt(y)));
    }
  }
}

}  // namespace
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
namespace {

using HWY_NAMESPACE::Margins;

static_assert(Margins<double>::kDiscriminantShare > Signs<53>::kDiscriminantShare &&
              Margins<double>::kNearShare > Signs<53>::kNearShare &&
              Margins<double>::kFarShare > Signs<53>::kFarShare &&
              Margins<double>::kSurfaceShare > Signs<53>::kSurfaceShare);

/// A part, the number of its inputs, and the number of inputs with a certain class.
struct Enumerated {
  Part part;
  std::int64_t inputs;
  double least_share;
};

HWY_EXPORT(enumerate_in);

Tally enumerate(int bits, Margin margin, const Part& part) {
  return HWY_DYNAMIC_DISPATCH(enumerate_in)(bits, margin, part);
}

void expect_no_wrong_class(int bits, const std::vector<Enumerated>& parts) {
  for (const auto& [part, inputs, least_share] : parts) {
    const Tally tally = enumerate(bits, Margin::kRight, part);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_EQ(tally.inputs, inputs);
    EXPECT_GE(tally.share(), least_share);
  }
}

/// 306,152,991 inputs. In the plane, which SmallPlane enumerates completely: every centre and
/// radius with directions up to 6, and every direction with centres and radii up to 12. Far
/// origins, whose differences to centres are rounded. In space: all numbers up to 10.
TEST(SmallFormats, HaveNoWrongClassIn8Bits) {
  expect_no_wrong_class(6, {
                               {{{0, 0, 0}, {6, 6, 0}, {252, 252, 0}, 252}, 86778432, 0.68},
                               {{{0, 0, 0}, {252, 252, 0}, {12, 12, 0}, 12}, 24991200, 0.61},
                               {{{252, 3, 0}, {3, 3, 0}, {252, 0, 0}, 31}, 89701584, 0.43},
                               {{{0, 0, 0}, {10, 10, 10}, {10, 10, 10}, 10}, 104681775, 0.67},
                           });
}

/// 478,090,863 inputs of the same kinds: in the plane every centre near the x axis with every
/// radius, and every direction; far origins; and space.
TEST(SmallFormats, HaveNoWrongClassIn10Bits) {
  expect_no_wrong_class(8, {
                               {{{0, 0, 0}, {6, 6, 0}, {1020, 15, 0}, 1020}, 212744448, 0.87},
                               {{{0, 0, 0}, {1020, 1020, 0}, {6, 6, 0}, 6}, 56661696, 0.86},
                               {{{1020, 1, 0}, {2, 2, 0}, {7, 1, 0}, 255}, 104002944, 0.82},
                               {{{0, 0, 0}, {10, 10, 10}, {10, 10, 10}, 10}, 104681775, 0.90},
                           });
}

/// All 17,355,686,400 inputs in the plane with the origin at 0, in quarters by their directions.
/// One of them is enumerated before each change, the others by .ci/nightly.
class SmallPlane : public testing::TestWithParam<std::size_t> {};

TEST_P(SmallPlane, HasNoWrongClassIn8Bits) {
  constexpr std::int64_t kInputs = 17355686400;
  expect_no_wrong_class(
      6, {{{{0, 0, 0}, {252, 252, 0}, {252, 252, 0}, 252, GetParam(), 4}, kInputs / 4, 0.67}});
}

INSTANTIATE_TEST_SUITE_P(LongFirst, SmallPlane, testing::Values(0));
INSTANTIATE_TEST_SUITE_P(NightlyOther, SmallPlane, testing::Range<std::size_t>(1, 4));

/// Margins that are too small are detected; in 10 bits all except two.
TEST(SmallFormats, HaveWrongClassesIfMutated) {
  for (std::size_t k = 1; k < kMarginCount; ++k) {
    SCOPED_TRACE(k);
    const Margin margin{k};
    EXPECT_GT(enumerate(6, margin, {{0, 0, 0}, {7, 7, 0}, {63, 63, 0}, 31}).wrong, 0);
    if (margin == Margin::kNoFarDoubt || margin == Margin::kNoSurface) continue;
    EXPECT_GT(enumerate(8, margin, {{0, 0, 0}, {4, 4, 0}, {255, 7, 0}, 255}).wrong, 0);
  }
}

HWY_EXPORT(expect_rounded);

TEST(SmallFormats, AreRoundedToNearestAndTiesToEven) { HWY_DYNAMIC_DISPATCH(expect_rounded)(); }

}  // namespace
}  // namespace raycheck::fast
#endif
