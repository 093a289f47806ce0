#include "reference/error_measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "tests/numbers.h"
#include "tests/reference/big_float.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

Enclosure real(double x) { return Enclosure(x, 192); }
Enclosure3 real3(double x, double y, double z) { return {real(x), real(y), real(z)}; }

TEST(UlpError, CountsTheGapAroundTheTruth) {
  EXPECT_EQ(ulp_error(1, real(1)), 0);
  EXPECT_EQ(ulp_error(nudged(1.5, 1), real(1.5)), 1);
  EXPECT_EQ(ulp_error(nudged(-1.5, 3), real(-1.5)), 3);
  const Enclosure between = real(1.5) + real(0x1p-54);
  EXPECT_EQ(ulp_error(1.5, between), 0.25);
  EXPECT_EQ(ulp_error(nudged(1.5, 1), between), 0.75);
}

TEST(UlpError, JustAboveAPowerOfTwoTheGapIsTwiceTheOneBelow) {
  EXPECT_EQ(ulp_error(nudged(1, 1), real(1)), 1);
  EXPECT_EQ(ulp_error(nudged(1, -1), real(1)), 0.5);
  EXPECT_EQ(ulp_error(1, real(nudged(1, -1))), 1);
  EXPECT_EQ(ulp_error(1, real(1) - real(0x1p-54)), 0.5);
}

TEST(UlpError, OfSubnormalsCountsTheSmallestDouble) {
  EXPECT_EQ(ulp_error(2 * kSmallest, real(kSmallest)), 1);
  EXPECT_EQ(ulp_error(0, real(5 * kSmallest)), 5);
  EXPECT_EQ(ulp_error(nudged(kSmallestNormal, -2), real(kSmallestNormal)), 2);
  EXPECT_EQ(ulp_error(nudged(2 * kSmallestNormal, 1), real(2 * kSmallestNormal)), 1);
  const Enclosure below_all = real(kSmallest) * real(0.25);
  EXPECT_EQ(ulp_error(0, below_all), 0.25);
  EXPECT_EQ(ulp_error(kSmallest, below_all), 0.75);
}

TEST(UlpError, OfAnExactZeroIsNothingOrEverything) {
  EXPECT_EQ(ulp_error(0, real(0)), 0);
  EXPECT_EQ(ulp_error(-0.0, real(0)), 0);
  EXPECT_EQ(ulp_error(kSmallest, real(0)), kInfinity);
}

TEST(UlpError, OfWhatIsNotFiniteIsInfinite) {
  for (const double given : {kInfinity, -kInfinity, kNaN}) {
    EXPECT_EQ(ulp_error(given, real(1)), kInfinity);
    EXPECT_EQ(ulp_error(given, real(kLargest)), kInfinity);
  }
}

TEST(UlpError, SpansTheWholeRange) {
  EXPECT_EQ(ulp_error(nudged(kLargest, -1), real(kLargest)), 1);
  EXPECT_EQ(ulp_error(-1, real(1)), 0x1p53);
  EXPECT_EQ(ulp_error(1, real(kSmallest)), kInfinity);
  EXPECT_EQ(ulp_error(kSmallest, real(1)), 0x1p52);
}

TEST(UlpError, IsAnUpperBoundThatANarrowEnclosureMakesSharp) {
  Random random(1);
  for (int k = 0; k < 3000; ++k) {
    const double truth = any_double(random);
    if (truth == 0 || std::abs(truth) == kLargest) continue;
    const double given = nudged(truth, random.integer(-9, 9));
    const Enclosure ball = Enclosure::within(truth, 0x1p-80, 256);
    const Big magnitude = abs(Big(truth));
    int exponent = 0;
    (void)std::frexp(truth, &exponent);
    const Big error = abs(Big(given) - Big(truth)) / power_of_two(std::max(exponent - 53, -1074));
    const double bound = ulp_error(given, ball);
    ASSERT_GE(Big(bound), error) << scene::hexfloat(truth);
    // An enclosure of a power of two reaches below it, where the gap is half as wide.
    const bool is_power_of_two = magnitude == power_of_two(exponent - 1);
    ASSERT_LE(Big(bound), error * (is_power_of_two ? 2 : 1) + power_of_two(-25));
  }
}

TEST(UlpError, OfATruthThatIsNotBoundedIsInfinite) {
  EXPECT_EQ(ulp_error(1, Enclosure(1) / Enclosure(0)), kInfinity);
  EXPECT_EQ(ulp_error(1, Enclosure(0) / Enclosure(0)), kInfinity);
}

TEST(RelativeError, IsTheDistanceOverTheLengthInUnitsOfU) {
  // (3, 4, 0) is 5 long; moved by 2^-50 along z.
  const double expected = 0x1p-50 / 5 * 0x1p53;
  const double error = relative_error(scene::Point3{3, 4, 0x1p-50}, real3(3, 4, 0));
  EXPECT_GE(error, expected * (1 - 1e-15));
  EXPECT_LE(error, expected * (1 + 1e-15));
  EXPECT_EQ(relative_error(scene::Point3{3, 4, 12}, real3(3, 4, 12)), 0);
  EXPECT_EQ(relative_error(scene::UnitVector3{1, 0, 0x1p-53}, real3(1, 0, 0)), 1);
}

TEST(RelativeError, OfTheOriginIsNothingOrEverything) {
  EXPECT_EQ(relative_error(scene::Point3{0, 0, 0}, real3(0, 0, 0)), 0);
  EXPECT_EQ(relative_error(scene::Point3{0, kSmallest, 0}, real3(0, 0, 0)), kInfinity);
  EXPECT_EQ(relative_error(scene::Point3{0, kNaN, 0}, real3(1, 0, 0)), kInfinity);
  EXPECT_EQ(relative_error(scene::Point3{kInfinity, 0, 0}, real3(1, 0, 0)), kInfinity);
}

TEST(AngleError, IsBlindToLength) {
  const Enclosure3 exact = real3(0.6, 0.8, 0);
  EXPECT_EQ(angle_error({1.2, 1.6, 0}, exact), 0);
  const double error = angle_error({1, 0x1p-53, 0}, real3(1, 0, 0));
  EXPECT_EQ(error, 1);
  EXPECT_EQ(angle_error({2, 0x1p-52, 0}, real3(1, 0, 0)), 1);
}

TEST(AngleError, FromARightAngleOnIsInfinite) {
  EXPECT_EQ(angle_error({0, 1, 0}, real3(1, 0, 0)), kInfinity);
  EXPECT_EQ(angle_error({-1, 0, 0}, real3(1, 0, 0)), kInfinity);
  EXPECT_EQ(angle_error({0, 0, 0}, real3(1, 0, 0)), kInfinity);
  EXPECT_EQ(angle_error({kNaN, 0, 0}, real3(1, 0, 0)), kInfinity);
  EXPECT_LT(angle_error({1, 1000, 0}, real3(1, 0, 0)), 1001 * 0x1p53);
}

TEST(UnitDefect, IsHowFarTheLengthIsFromOne) {
  EXPECT_EQ(unit_defect({1, 0, 0}), 0);
  EXPECT_EQ(unit_defect({0, -2, 0}), 0x1p53);
  EXPECT_EQ(unit_defect({0, 0, 0}), 0x1p53);
  for (const auto& [z, exact] : {std::pair(nudged(1, 1), 2.0), {nudged(1, -1), 1.0}}) {
    EXPECT_GE(unit_defect({0, 0, z}), exact);
    EXPECT_LE(unit_defect({0, 0, z}), exact * (1 + kUnitDefectWidth));
  }
  EXPECT_EQ(unit_defect({0, kInfinity, 0}), kInfinity);
  // 0.6 and 0.8 are rounded: their squares do not quite sum to 1.
  const Big length = sqrt(Big(0.6) * Big(0.6) + Big(0.8) * Big(0.8));
  const Big expected = abs(length - 1) * power_of_two(53);
  const double defect = unit_defect({0.6, 0.8, 0});
  EXPECT_GE(Big(defect), expected);
  EXPECT_LE(Big(defect), expected * (1 + kUnitDefectWidth));
}

TEST(InUnitsOfU, BoundsFromAbove) {
  EXPECT_EQ(in_units_of_u(real(-0x1p-53)), 1);
  EXPECT_EQ(in_units_of_u(real(0)), 0);
  EXPECT_EQ(in_units_of_u(real(kLargest)), kInfinity);
  EXPECT_EQ(in_units_of_u(Enclosure(1) / Enclosure(0)), kInfinity);
}

TEST(EncloseExactly, HoldsTheGivenDoublesAndNothingElse) {
  const Enclosure3 ball = enclose_exactly(scene::Point3{0.1, -kSmallest, kLargest});
  EXPECT_EQ(ball.x.lower(), 0.1);
  EXPECT_EQ(ball.x.upper(), 0.1);
  EXPECT_EQ(ball.y.upper(), -kSmallest);
  EXPECT_EQ(ball.z.lower(), kLargest);
  EXPECT_EQ(enclose_exactly(scene::Vector3{0.1, 0, 0}).x.relative_radius(), 0);
  EXPECT_EQ(enclose_exactly(scene::UnitVector3{0.1, 0, 0}).x.upper(), 0.1);
}

}  // namespace
}  // namespace raycheck::reference
