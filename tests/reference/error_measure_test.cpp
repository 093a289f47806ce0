#include "reference/error_measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "tests/numbers.h"
#include "tests/reference/big_float.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

Enclosure real(double x) { return Enclosure(x, 192); }
Enclosure3 real3(double x, double y, double z) { return {real(x), real(y), real(z)}; }

struct UlpCase {
  const char* what;
  double given;
  Enclosure exact;
  double ulp;
  scene::Precision precision = scene::Precision::kDouble;
};

TEST(UlpError, IsCountedInGapsAroundTheTruth) {
  constexpr auto kSingle = scene::Precision::kSingle;
  const Enclosure between = real(1.5) + real(0x1p-54), below_all = real(kSmallest) * real(0.25);
  for (const auto& [what, given, exact, ulp, precision] : std::vector<UlpCase>{
           {"none", 1, real(1), 0},
           {"of a negative", nudged(-1.5, 3), real(-1.5), 3},
           {"of no double, below", 1.5, between, 0.25},
           {"of no double, above", nudged(1.5, 1), between, 0.75},
           {"above a power of two", nudged(1, 1), real(1), 1},
           {"below it, where doubles are nearer", nudged(1, -1), real(1), 0.5},
           {"of what is below it", 1, real(1) - real(0x1p-54), 0.5},
           {"of subnormals", 0, real(5 * kSmallest), 5},
           {"below the normal ones", nudged(kSmallestNormal, -2), real(kSmallestNormal), 2},
           {"of less than any", 0, below_all, 0.25},
           {"of less than any, above", kSmallest, below_all, 0.75},
           {"of a zero", -0.0, real(0), 0},
           {"of a zero, missed", kSmallest, real(0), kInfinity},
           {"at the end of the range", nudged(kLargest, -1), real(kLargest), 1},
           {"of the wrong sign", -1, real(1), 0x1p53},
           {"too many to count", 1, real(kSmallest), kInfinity},
           {"infinite", kInfinity, real(kLargest), kInfinity},
           {"no number", kNaN, real(1), kInfinity},
           {"of a truth without bounds", 1, Enclosure(1) / Enclosure(0), kInfinity},
           {"of a float", 1 + 0x1p-23, real(1), 1, kSingle},
           {"below a power of two of floats", 1 - 0x1p-24, real(1), 0.5, kSingle},
           {"of no float", 3, real(3 + 0x1p-24), 0.25, kSingle},
           {"of subnormal floats", 0, real(0x1p-140), 0x1p9, kSingle},
           {"of less than any float", 0x1p-149, real(0x1p-151), 0.75, kSingle},
           {"below the normal floats", 0x1p-126, real(0x1p-126 - 0x1p-149), 1, kSingle},
           {"at twice the least of these", 0x1p-125, real(0x1p-125 + 0x1p-148), 1, kSingle}}) {
    EXPECT_EQ(ulp_error(given, exact, precision).value, ulp) << what;
  }
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
    const double bound = ulp_error(given, ball).value;
    ASSERT_GE(Big(bound), error) << scene::hexfloat(truth);
    // An enclosure of a power of two reaches below it, where the gap is half as wide.
    const bool is_power_of_two = magnitude == power_of_two(exponent - 1);
    ASSERT_LE(Big(bound), error * (is_power_of_two ? 2 : 1) + power_of_two(-25));
  }
}

TEST(RelativeError, IsTheDistanceOverTheLengthInUnitsOfU) {
  // (3, 4, 0) is 5 long; moved by 2^-50 along z.
  const double expected = 0x1p-50 / 5 * 0x1p53;
  const double error = relative_error(scene::Point3{3, 4, 0x1p-50}, real3(3, 4, 0)).value;
  EXPECT_GE(error, expected * (1 - 1e-15));
  EXPECT_LE(error, expected * (1 + 1e-15));
  EXPECT_EQ(relative_error(scene::Point3{3, 4, 12}, real3(3, 4, 12)).value, 0);
  EXPECT_EQ(relative_error(scene::UnitVector3{1, 0, 0x1p-53}, real3(1, 0, 0)).value, 1);
}

TEST(RelativeError, OfTheOriginIsNothingOrEverything) {
  EXPECT_EQ(relative_error(scene::Point3{0, 0, 0}, real3(0, 0, 0)).value, 0);
  EXPECT_EQ(relative_error(scene::Point3{0, kSmallest, 0}, real3(0, 0, 0)).value, kInfinity);
  EXPECT_EQ(relative_error(scene::Point3{0, kNaN, 0}, real3(1, 0, 0)).value, kInfinity);
  EXPECT_EQ(relative_error(scene::Point3{kInfinity, 0, 0}, real3(1, 0, 0)).value, kInfinity);
}

TEST(RelativeError, OfDoublesIsThatOfTheirEnclosures) {
  const scene::UnitVector3 exact = {0.6, -0.8, 0};
  for (const scene::UnitVector3& given :
       {exact, scene::UnitVector3{0.6, -0.8, 0x1p-53}, scene::UnitVector3{0, 0, 0},
        scene::UnitVector3{kNaN, -0.8, 0}, scene::UnitVector3{kInfinity, -0.8, 0}}) {
    const double error = relative_error(given, real3(exact.x, exact.y, exact.z)).value;
    EXPECT_EQ(relative_error(given, exact).value, error);
  }
  const scene::UnitVector3 infinite = {kInfinity, 0, 0};
  EXPECT_EQ(relative_error(infinite, infinite).value, kInfinity);
}

TEST(AngleError, IsBlindToLength) {
  const Enclosure3 exact = real3(0.6, 0.8, 0);
  EXPECT_EQ(angle_error({1.2, 1.6, 0}, exact).value, 0);
  const double error = angle_error({1, 0x1p-53, 0}, real3(1, 0, 0)).value;
  EXPECT_EQ(error, 1);
  EXPECT_EQ(angle_error({2, 0x1p-52, 0}, real3(1, 0, 0)).value, 1);
}

TEST(AngleError, FromARightAngleOnIsInfinite) {
  EXPECT_EQ(angle_error({0, 1, 0}, real3(1, 0, 0)).value, kInfinity);
  EXPECT_EQ(angle_error({-1, 0, 0}, real3(1, 0, 0)).value, kInfinity);
  EXPECT_EQ(angle_error({0, 0, 0}, real3(1, 0, 0)).value, kInfinity);
  EXPECT_EQ(angle_error({kNaN, 0, 0}, real3(1, 0, 0)).value, kInfinity);
  EXPECT_LT(angle_error({1, 1000, 0}, real3(1, 0, 0)).value, 1001 * 0x1p53);
}

TEST(UnitDefect, IsHowFarTheLengthIsFromOne) {
  EXPECT_EQ(unit_defect({1, 0, 0}).value, 0);
  EXPECT_EQ(unit_defect({0, -2, 0}).value, 0x1p53);
  EXPECT_EQ(unit_defect({0, 0, 0}).value, 0x1p53);
  for (const auto& [z, exact] : {std::pair(nudged(1, 1), 2.0), {nudged(1, -1), 1.0}}) {
    EXPECT_GE(unit_defect({0, 0, z}).value, exact);
    EXPECT_LE(unit_defect({0, 0, z}).value, exact * (1 + kUnitDefectWidth));
  }
  EXPECT_EQ(unit_defect({0, kInfinity, 0}).value, kInfinity);
  // 0.6 and 0.8 are rounded: their squares do not quite sum to 1.
  const Big length = sqrt(Big(0.6) * Big(0.6) + Big(0.8) * Big(0.8));
  const Big expected = abs(length - 1) * power_of_two(53);
  const double defect = unit_defect({0.6, 0.8, 0}).value;
  EXPECT_GE(Big(defect), expected);
  EXPECT_LE(Big(defect), expected * (1 + kUnitDefectWidth));
}

TEST(InUnitsOfU, BoundsFromAbove) {
  EXPECT_EQ(in_units_of_u(real(-0x1p-53)).value, 1);
  EXPECT_EQ(in_units_of_u(real(0)).value, 0);
  EXPECT_EQ(in_units_of_u(real(kLargest)).value, kInfinity);
  EXPECT_EQ(in_units_of_u(Enclosure(1) / Enclosure(0)).value, kInfinity);
}

}  // namespace
}  // namespace raycheck::reference
