#pragma once

// What must not be negative, several at once, over a box. Internal to reference/.

#include <cstddef>
#include <vector>

#include "reference/account/internal/answer_decider.h"

namespace raycheck::reference {

/// How many linear programs follow one another.
inline constexpr int kPrograms = 8;

/// Where all of the variations, those that are known to first order, are least negative: a point of
/// the box of that many dimensions.
LeastOptimum best_place(const std::vector<Variation>& all, std::size_t dimension);

/// Whether a sum of them, each times its multiplier, is negative everywhere, so that they are
/// nowhere all without one that is.
bool exclude_each_other(const std::vector<Variation>& all, const std::vector<double>& multipliers);

/// Whether that shows at their best place.
inline bool exclude_each_other(const std::vector<Variation>& all, const LeastOptimum& best) {
  return best.least < 0 && exclude_each_other(all, best.multipliers);
}

}  // namespace raycheck::reference
