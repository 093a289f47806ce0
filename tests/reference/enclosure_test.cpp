#include "reference/enclosure.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/numbers.h"
#include "tests/reference/big_float.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

/// x exactly, at a precision that holds all of it.
Enclosure exactly(const Big& x) {
  Enclosure result(0, 8000);
  arf_set_mpfr(arb_midref(result.ball()), x.backend().data());
  return result;
}

TEST(EnclosureRounding, AgreesWithMpfrEverywhere) {
  Random random(1);
  int subnormal = 0;
  int ties = 0;
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
      const double a = number(random, sizes);
      const double b = number(random, sizes);
      const double c = number(random, sizes);
      const int bits = static_cast<int>(random.integer(2, 200));
      const Enclosure x(a, bits);
      const Enclosure y(b, bits);
      const Enclosure z(c, bits);
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

TEST(EnclosureSqrt, CutsOffWhatIsNegative) {
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

}  // namespace
}  // namespace raycheck::reference
