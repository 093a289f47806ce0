#pragma once

// Several functions that must not be negative, over a box. Internal to reference/.

#include <cstddef>
#include <vector>

#include "reference/account/internal/answer_decider.h"

namespace raycheck::reference {

/// The number of successive linear programs.
inline constexpr int kPrograms = 8;

/// Where all of the variations, those that are known to first order, are least negative: a point of
/// the box of that many dimensions.
LeastOptimum best_place(const std::vector<Variation>& all, std::size_t dimension);

/// Whether their sum, each times its multiplier, is negative everywhere, so that everywhere one of
/// them is negative.
bool exclude_each_other(const std::vector<Variation>& all, const std::vector<double>& multipliers);

/// Whether their best place shows that.
inline bool exclude_each_other(const std::vector<Variation>& all, const LeastOptimum& best) {
  return best.least < 0 && exclude_each_other(all, best.multipliers);
}

}  // namespace raycheck::reference
