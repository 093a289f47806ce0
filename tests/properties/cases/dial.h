#pragma once

// Whether a family's dial sets what it says, measured from the doubles of its cases with
// enclosures, never with the generator's own arithmetic.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "properties/cases/case_source.h"
#include "reference/enclosure.h"
#include "tests/names.h"

namespace raycheck::properties {

using reference::Enclosure;
using reference::Enclosure3;

/// Keeps short products of doubles within a factor of 2^50 of each other exact.
inline constexpr int kDialBits = 512;
inline constexpr double kUnitRoundoff = 0x1p-53;

inline Enclosure lift(double x) { return {x, kDialBits}; }
template <class Triple>
Enclosure3 lift(const Triple& v) {
  return {lift(v.x), lift(v.y), lift(v.z)};
}

/// What the dial sets, in one place of a case, and by how much the rounding of the case's own
/// numbers may move it: where that is more than severity asks for, it is what there is.
struct Measured {
  Enclosure value;
  double noise = 0;
};

/// Factors for what two roundings may move.
inline constexpr double kBelow = 1 - 0x1p-40;
inline constexpr double kAbove = 1 + 0x1p-40;

/// A family whose severity k sets a value to base^k (or its inverse, or either) up to a factor.
struct DialRow {
  std::string_view family;
  enum class Sets { kPower, kInverse, kEither } sets;
  double least;  ///< Factor of the power that values are at least,
  double most;   ///< and at most.
  int highest;   ///< Severities above are tested on their own.
  std::vector<Measured> (*measure)(const Case&);
};

inline void PrintTo(const DialRow& row, std::ostream* out) { *out << row.family; }
inline std::string test_name(const testing::TestParamInfo<DialRow>& the_test) {
  return identifier(the_test.param.family);
}

/// Severities to try: 0, `highest`, and others between, 16 steps at the most.
inline std::vector<int> severities(int highest) {
  std::vector<int> result;
  for (int k = 0; k < highest; k += std::max(1, highest / 16)) result.push_back(k);
  result.push_back(highest);
  return result;
}

inline Enclosure power(int base, int exponent) {
  Enclosure result = lift(1.0);
  for (int k = 0; k < std::abs(exponent); ++k) result *= Enclosure(base);
  return exponent < 0 ? Enclosure(1) / result : result;
}

inline bool is_around(const Measured& measured, const Enclosure& scale, const DialRow& row) {
  const Enclosure noise = lift(measured.noise);
  const auto is_at_least = [](const Enclosure& a, const Enclosure& b) {
    return (a - b).certain_sign().value_or(-1) >= 0;
  };
  return is_at_least(measured.value, lift(row.least) * scale - noise) &&
         is_at_least(lift(row.most) * scale + noise, measured.value);
}

inline constexpr std::uint64_t kDialSeeds = 100;

inline void expect_dial(const DialRow& row) {
  const CaseSource& source = *find_case_source(row.family);
  for (const int severity : severities(row.highest)) {
    SCOPED_TRACE(std::string(row.family) + "@" + std::to_string(severity));
    const Enclosure up = power(source.dial->base, severity);
    const Enclosure down = power(source.dial->base, -severity);
    std::size_t measured = 0;
    for (std::uint64_t seed = 0; seed < kDialSeeds; ++seed) {
      for (const Measured& value : row.measure(source.make(severity, seed))) {
        ++measured;
        const bool fits_up = row.sets != DialRow::Sets::kInverse && is_around(value, up, row);
        const bool fits_down = row.sets != DialRow::Sets::kPower && is_around(value, down, row);
        EXPECT_TRUE(fits_up || fits_down) << value.value.lower() << ", seed " << seed;
      }
    }
    EXPECT_GE(measured, kDialSeeds);
  }
}

/// How often a ray starts outside a sphere or inside, towards its centre or away from it.
struct Sides {
  std::array<int, 4> counts = {};

  void count(const Enclosure& to_centre, const Enclosure& axial, const Enclosure& radius) {
    const bool outside = (to_centre - radius).certain_sign() == 1;
    ++counts[(outside ? 2u : 0u) + (axial.certain_sign() == 1 ? 1u : 0u)];
  }
};

template <class Count>
void expect_every_side(std::string_view family, std::initializer_list<int> some, Count count) {
  for (const int severity : some) {
    Sides sides;
    for (std::uint64_t seed = 0; seed < 2 * kDialSeeds; ++seed) {
      count(find_case_source(family)->make(severity, seed), sides);
    }
    for (const int side : sides.counts) EXPECT_GT(side, 40) << family << "@" << severity;
  }
}

}  // namespace raycheck::properties
