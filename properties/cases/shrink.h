#pragma once

#include <functional>
#include <vector>

#include "properties/case.h"

namespace raycheck::properties {

/// The complexity of a double: its significant bits, the distance of its exponent from 0, and its
/// sign; 0 for 0. Shrinking only lowers it, so it terminates.
int complexity(double value);

/// Simpler doubles to try in place of one, the simplest first: 0, 1, whole numbers, fewer bits.
std::vector<double> simpler(double value);

/// Valid cases that are simpler in one respect: a sphere, pixel or ray fewer, a convention at its
/// default, a smaller image, one number simpler.
std::vector<Case> simpler(const Case& the_case);

/// Follows steps of simpler() from a case, each to the first case for which `still` holds; tries at
/// most `tries` cases.
Case smallest(Case from, int tries, const std::function<bool(const Case&)>& still);

}  // namespace raycheck::properties
