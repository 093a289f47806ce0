// Compares enclosures and double-doubles with MPFR.

#include "reference/enclosure.h"

#include "reference/internal/double_double.h"
#include "tests/reference/big_float.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

Enclosure exactly(const Big& x) {
  Enclosure result(0, 8000);
  arf_set_mpfr(arb_midref(result.ball()), x.backend().data());
  return result;
}

TEST(EnclosureRounding, AgreesWithMpfrEverywhere) {
  Random random(1);
  int subnormal = 0, ties = 0;
  for (int k = 0; k < 20000; ++k) {
    const double value = any_double(random);
    const Big tie = halfway(value, kInfinity);
    const Big offset =
        random.small_integer(1) * power_of_two(static_cast<int>(random.integer(-2000, -1080)));
    const Big x = random.one_in(3) ? Big(tie + offset) : Big(Big(value) * (1 + offset));
    const Enclosure ball = exactly(x);
    ASSERT_TRUE(is_nearest(ball.lower_rounded(), x)) << scene::hexfloat(value) << " " << offset;
    ASSERT_EQ(ball.lower_rounded(), ball.upper_rounded());
    ASSERT_EQ(ball.lower(), mpfr_get_d(x.backend().data(), MPFR_RNDD));
    ASSERT_EQ(ball.upper(), mpfr_get_d(x.backend().data(), MPFR_RNDU));
    subnormal += ball.upper() != 0 && std::abs(ball.upper()) < kSmallestNormal ? 1 : 0;
    ties += x == tie ? 1 : 0;
  }
  EXPECT_GE(subnormal, 500);
  EXPECT_GE(ties, 1000);
}

TEST(EnclosureRounding, TheTwoRoundingsDifferExactlyWhenTheBallHoldsAMidpoint) {
  const Enclosure wide = Enclosure::within(1, 0x1.4p-53, 128);
  EXPECT_EQ(wide.lower_rounded(), nudged(1, -1));
  EXPECT_EQ(wide.upper_rounded(), nudged(1, 1));
  const Enclosure narrow = Enclosure::within(1, 0x1p-55, 128);
  EXPECT_EQ(narrow.lower_rounded(), 1);
  EXPECT_EQ(narrow.upper_rounded(), 1);
}

TEST(EnclosureArithmetic, ContainsTheTruth) {
  Random random(2);
  for (const Sizes sizes : {Sizes::kOrdinary, Sizes::kAll}) {
    for (int k = 0; k < 3000; ++k) {
      const auto [a, b, c] = triple<scene::Vector3>(random, sizes);
      const int bits = static_cast<int>(random.integer(2, 200));
      const Enclosure x(a, bits), y(b, bits), z(c, bits);
      const Enclosure sum = x * y + z;
      const Big truth = Big(a) * Big(b) + Big(c);
      ASSERT_TRUE(contains(sum, truth));
      ASSERT_TRUE(sum.lower() == -kInfinity || Big(sum.lower()) <= truth);
      ASSERT_TRUE(sum.upper() == kInfinity || Big(sum.upper()) >= truth);
      ASSERT_TRUE(contains(x - y * z, Big(a) - Big(b) * Big(c)));
      ASSERT_TRUE(contains(-abs(x - y), -abs(Big(a) - Big(b))));
      ASSERT_TRUE(contains(sqrt(abs(x * y)), sqrt(abs(Big(a) * Big(b)))));
      if (c != 0) {
        ASSERT_TRUE(contains((x - y) / z, (Big(a) - Big(b)) / Big(c)));
      }
    }
  }
}

TEST(EnclosureArithmetic, WithinHoldsBothEnds) {
  const Enclosure ball = Enclosure::within(-3, 0x1p-60, 256);
  EXPECT_TRUE(contains(ball, -3 * (1 + power_of_two(-60))));
  EXPECT_TRUE(contains(ball, -3 * (1 - power_of_two(-60))));
  EXPECT_FALSE(contains(ball, -3 * (1 + power_of_two(-59))));
  EXPECT_EQ(Enclosure::within(0, 0x1p-60, 256).certain_sign(), 0);
}

TEST(EnclosureArithmetic, AQuotientByZeroBoundsNothing) {
  for (const int numerator : {0, 1}) {
    const Enclosure quotient = Enclosure(numerator) / Enclosure(0);
    EXPECT_EQ(quotient.lower(), -kInfinity);
    EXPECT_EQ(quotient.upper(), kInfinity);
    EXPECT_FALSE(quotient.certain_sign().has_value());
    EXPECT_FALSE(quotient.is_within(1));
  }
}

TEST(EnclosureSign, IsCertainOnlyWhenTheWholeBallHasIt) {
  EXPECT_EQ(Enclosure(kSmallest, 64).certain_sign(), 1);
  EXPECT_EQ(Enclosure(-kLargest, 64).certain_sign(), -1);
  EXPECT_EQ((Enclosure(1) - Enclosure(1)).certain_sign(), 0);
  const Enclosure third = Enclosure(1) / Enclosure(3);
  EXPECT_FALSE((third * Enclosure(3) - Enclosure(1)).certain_sign().has_value());
  EXPECT_TRUE((third * Enclosure(3) - Enclosure(1)).contains_zero());
}

TEST(EnclosureSqrt, CutsOffTheNegativePart) {
  const Enclosure around_zero = Enclosure(1) / Enclosure(3) * Enclosure(3) - Enclosure(1);
  const Enclosure root = sqrt(around_zero);
  EXPECT_TRUE(root.contains_zero());
  EXPECT_LT(root.upper(), 1e-9);
  EXPECT_EQ(sqrt(Enclosure(0)).upper(), 0);
}

TEST(EnclosureWidth, IsRelativeToTheValue) {
  const Enclosure ball = Enclosure::within(0x1p-1000, 0x1p-80, 256);
  EXPECT_TRUE(ball.is_within(79));
  EXPECT_FALSE(ball.is_within(82));
}

/// Whether x has a finite radius.
bool is_known(const DoubleDouble& x) {
  return std::isfinite(x.high()) && std::isfinite(x.radius());
}

void expect_holds(const DoubleDouble& x, const Big& exact, const std::string& what) {
  if (!is_known(x)) return;
  const Big error = abs(Big(x.high()) + Big(x.low()) - exact);
  // 2^-6000 |exact| bounds the rounding error of `exact` itself.
  EXPECT_TRUE(error <= Big(x.radius()) + abs(exact) * power_of_two(-6000))
      << what << ": " << scene::hexfloat(x.high()) << " + " << scene::hexfloat(x.low())
      << " within " << scene::hexfloat(x.radius()) << ", off by " << error.convert_to<double>();
  EXPECT_EQ(x.high(), x.high() + x.low()) << what;
  const Big centre = Big(x.high()) + Big(x.low());
  const auto expect_end = [&](double end, const Big& exact_end, int side) {
    if (!std::isfinite(end)) return;
    const Big outside = (Big(end) - exact_end) * side;
    EXPECT_TRUE(outside >= 0) << what;
    EXPECT_TRUE(outside <= abs(exact_end) * power_of_two(-51) + Big(2 * kSmallest)) << what;
  };
  expect_end(x.upper(), centre + Big(x.radius()), 1);
  expect_end(x.lower(), centre - Big(x.radius()), -1);
  if (const auto sign = x.certain_sign()) {
    EXPECT_EQ(*sign, exact > 0 ? 1 : exact < 0 ? -1 : 0) << what;
  }
  if (const auto nearest = x.nearest()) {
    for (const double towards : {-HUGE_VAL, HUGE_VAL}) {
      const double other = std::nextafter(*nearest, towards);
      if (!std::isfinite(other)) continue;
      EXPECT_TRUE(abs(Big(*nearest) - exact) <= abs(Big(other) - exact)) << what;
    }
  } else if (x.is_within(100)) {
    EXPECT_GT(std::abs(x.low()), std::abs(x.high()) * 0x1p-56) << what;  // near a midpoint
  }
  if (x.is_within(70)) {
    EXPECT_TRUE(error <= abs(exact) * power_of_two(-70)) << what;
  }
}

struct Pair {
  DoubleDouble number;
  Big exact;
};

/// A random operation on two pairs; empty if it has no result.
std::optional<Pair> operate(Random& random, const Pair& a, const Pair& b) {
  const auto kind = random.integer(1, 5);
  if (kind == 1) return Pair{a.number + b.number, a.exact + b.exact};
  if (kind == 2) return Pair{a.number - b.number, a.exact - b.exact};
  if (kind == 3) return Pair{a.number * b.number, a.exact * b.exact};
  if (kind == 4 && b.exact != 0) return Pair{a.number / b.number, a.exact / b.exact};
  if (kind == 5 && a.exact >= 0) return Pair{sqrt(a.number), sqrt(a.exact)};
  return std::nullopt;
}

/// Checks random expressions of a few operations each; returns the number of narrow results.
int check_expressions(Sizes sizes, std::uint64_t seed, int count) {
  Random random(seed);
  int narrow = 0;
  for (int k = 0; k < count; ++k) {
    std::vector<Pair> known;
    for (int input = 0; input < 4; ++input) {
      const double x = number(random, sizes);
      known.push_back({DoubleDouble(x), Big(x)});
      // Neighbours, whose differences cancel.
      const double close = nudged(x, random.integer(-3, 3));
      if (std::isfinite(close)) known.push_back({DoubleDouble(close), Big(close)});
      // An end of the interval of numbers within a relative change.
      const double change =
          std::ldexp(random.between(0.5, 1), -static_cast<int>(random.integer(0, 9)));
      const double end = random.sign();
      known.push_back({DoubleDouble(Enclosure::within(x, change, 256)),
                       Big(x) * (1 + Big(end) * Big(change) * (1 - power_of_two(-100)))});
    }
    for (int step = 0; step < 12; ++step) {
      const auto last = static_cast<std::int64_t>(known.size()) - 1;
      const Pair a = known[static_cast<std::size_t>(random.integer(0, last))];
      const Pair b = known[static_cast<std::size_t>(random.integer(0, last))];
      const auto result = operate(random, a, b);
      if (!result) continue;
      expect_holds(result->number, result->exact,
                   "expression " + std::to_string(k) + ", step " + std::to_string(step));
      if (!is_known(result->number)) continue;
      if (result->number.is_within(90)) ++narrow;
      known.push_back(*result);
    }
  }
  return narrow;
}

TEST(DoubleDouble, HoldsTheExactResultOfExpressions) {
  EXPECT_GE(check_expressions(Sizes::kOrdinary, 1, 5000), 20000);
  EXPECT_GE(check_expressions(Sizes::kSmallIntegers, 2, 3000), 12000);
  EXPECT_GE(check_expressions(Sizes::kAll, 3, 5000), 10000);
}

TEST(DoubleDouble, KeepsExactZeros) {
  const DoubleDouble zero(0), one(1);
  for (const DoubleDouble& result :
       {zero + zero, zero * one, zero / one, sqrt(zero), one - one, -zero}) {
    EXPECT_TRUE(result.is_exact_zero());
    EXPECT_EQ(result.certain_sign(), 0);
    EXPECT_TRUE(result.is_within(1000));
  }
  // A product that underflows is not zero.
  const DoubleDouble product = DoubleDouble(kSmallest) * DoubleDouble(kSmallest);
  EXPECT_EQ(product.certain_sign(), std::nullopt);
  EXPECT_FALSE(product.is_within(1));
}

TEST(DoubleDouble, KeepsExactResultsExact) {
  const DoubleDouble one(1), tiny(0x1p-60);
  for (const DoubleDouble& result :
       {one + tiny, (one + tiny) - one, DoubleDouble(0.1) * DoubleDouble(0.3),
        one / DoubleDouble(8), DoubleDouble(21) / DoubleDouble(7), sqrt(DoubleDouble(2.25)),
        DoubleDouble(0.1) - DoubleDouble(0.3)}) {
    EXPECT_EQ(result.radius(), 0);
    EXPECT_TRUE(result.is_within(1000));
  }
  for (const DoubleDouble& result :
       {one / DoubleDouble(3), sqrt(DoubleDouble(2)), (one + tiny) * (one + tiny)}) {
    EXPECT_GT(result.radius(), 0);
  }
}

TEST(DoubleDouble, HasNoSignOrWidthWhereNothingIsKnown) {
  const DoubleDouble zero(0), one(1), large(kLargest);
  const DoubleDouble root = sqrt(DoubleDouble(2));
  const DoubleDouble around_zero = root * root - DoubleDouble(2);
  const DoubleDouble huge = large * large;
  for (const DoubleDouble& result :
       {large + large, huge, -huge, huge - huge, huge / large, one / zero, zero / zero,
        one / around_zero, sqrt(around_zero), sqrt(-one), large / DoubleDouble(0.5), sqrt(huge),
        huge + one}) {
    EXPECT_EQ(result.certain_sign(), std::nullopt);
    EXPECT_FALSE(result.is_within(1));
  }
}

TEST(DoubleDouble, BecomesABallThatHoldsIt) {
  Random random(5);
  int compared = 0;
  for (int k = 0; k < 1000; ++k) {
    const DoubleDouble x = DoubleDouble(any_double(random)) + DoubleDouble(any_double(random));
    if (!is_known(x)) continue;
    ++compared;
    const Enclosure ball = x.enclosure();
    const Big centre = Big(x.high()) + Big(x.low());
    EXPECT_TRUE(contains(ball, centre - Big(x.radius())));
    EXPECT_TRUE(contains(ball, centre + Big(x.radius())));
    if (x.is_within(70)) {
      EXPECT_TRUE(ball.is_within(69));
    }
  }
  EXPECT_GE(compared, 500);
}

TEST(DoubleDouble, HoldsTheBallThatItComesFrom) {
  for (const double x : {1.0, -0x1p300, 0x1p-1000, 0x1p-1060, kSmallest, kLargest}) {
    for (const double y : {3.0, 0x1.8p-3, 0x1p-1074, 0x1p1000}) {
      const Enclosure ball = Enclosure(x, 256) / Enclosure(y, 256);
      expect_holds(DoubleDouble(ball), Big(x) / Big(y),
                   scene::hexfloat(x) + "/" + scene::hexfloat(y));
    }
  }
  const DoubleDouble third(Enclosure(1.0, 256) / Enclosure(3.0, 256));
  EXPECT_TRUE(third.is_within(100));
  EXPECT_TRUE(DoubleDouble(Enclosure(0)).is_exact_zero());
  const Enclosure beyond = Enclosure(kLargest, 256) * Enclosure(2.0, 256);
  EXPECT_FALSE(DoubleDouble(beyond).is_within(1));
}

}  // namespace
}  // namespace raycheck::reference
