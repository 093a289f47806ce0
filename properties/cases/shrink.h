#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "properties/case.h"

namespace raycheck::properties {

/// The complexity of a double: its significant bits, the distance of its exponent from 0, and its
/// sign; 0 for 0. Shrinking only lowers it, so it terminates.
int complexity(double value);

/// Simpler doubles to try in place of x, the simplest first: 0, 1, whole numbers, fewer bits.
std::vector<double> simpler(double value);

/// Valid cases that are simpler in one respect: without half of the spheres, pixels or rays,
/// without a quarter, and so on down to without one; with a convention at its default; with a
/// smaller image; or with one simpler number.
std::vector<Case> simpler(const Case& the_case);

/// The budget of shrinking: cases to try, and their spheres, rays and pixels in total.
struct ShrinkBudget {
  static constexpr std::int64_t kParts = 2'000'000;

  std::int64_t tries = std::numeric_limits<std::int64_t>::max(), parts = kParts;

  bool is_spent() const { return tries <= 0 || parts <= 0; }
};

/// Replaces the case by the first case in simpler() for which `still` holds, as often as there is
/// one and the budget lasts. Subtracts the cost from the budget.
Case smallest(Case from, ShrinkBudget& budget, const std::function<bool(const Case&)>& still);

}  // namespace raycheck::properties
