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

/// Valid cases that are simpler in one respect: half of the spheres, pixels or rays, a quarter, and
/// so on to one of them fewer, a convention at its default, a smaller image, one number simpler.
std::vector<Case> simpler(const Case& the_case);

/// The budget of shrinking: cases to try, and their spheres, rays and pixels in total.
struct ShrinkBudget {
  static constexpr std::int64_t kParts = 2'000'000;

  std::int64_t tries = std::numeric_limits<std::int64_t>::max(), parts = kParts;

  bool is_spent() const { return tries <= 0 || parts <= 0; }
};

/// Follows steps of simpler() from a case, each to the first case for which `still` holds, until
/// none is left or the budget is used up. Subtracts the cost from the budget.
Case smallest(Case from, ShrinkBudget& budget, const std::function<bool(const Case&)>& still);

}  // namespace raycheck::properties
