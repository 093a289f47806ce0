#pragma once

// What the tests of condition numbers share.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "reference/account/condition.h"
#include "tests/reference/big_float.h"

namespace raycheck::reference {

inline std::array<Big, 3> coordinates_of(const Big3& v) { return {v.x, v.y, v.z}; }

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Of two upper bounds, or a bound and the value itself: the stated width, and one for rounding.
inline constexpr double kAgreement = 1.25 * kConditionWidth;

/// Checks a condition number against its exact value.
inline void expect_condition(double bound, const Big& exact, const std::string& what) {
  if (exact > Big(std::numeric_limits<double>::max())) {
    EXPECT_EQ(bound, kUnbounded) << what;
    return;
  }
  EXPECT_TRUE(Big(bound) >= exact * (1 - power_of_two(-50)))
      << what << ": " << bound << " below " << exact.convert_to<double>();
  EXPECT_TRUE(Big(bound) <= exact * (1 + kAgreement) + kNegligibleCondition)
      << what << ": " << bound << " above " << exact.convert_to<double>();
}

/// Checks two bounds of one condition number.
inline void expect_same_condition(double one, double other, const std::string& what) {
  if (one == other) return;
  EXPECT_LE(std::abs(one - other), kAgreement * other + kNegligibleCondition)
      << what << ": " << one << " and " << other;
}

}  // namespace raycheck::reference
