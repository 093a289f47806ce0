#pragma once

// The length of a vector that varies over a box, by its components along directions: they are
// linear in the inputs, while its square is not. Internal to reference/.

#include <array>
#include <functional>
#include <vector>

#include "reference/account/internal/answer_decider.h"

namespace raycheck::reference {

/// A vector, and the length that it is compared with.
struct VectorAndLength {
  std::array<Variation, 3> vector;
  Variation length;
};

/// Where the vector is shortest, or nearly: a point of the box, and the direction there.
struct Shortest {
  std::vector<double> t;
  std::array<double, 3> direction;
};
Shortest shortest(const VectorAndLength& both);
/// The length minus the vector's component along a direction: >= 0 if the vector is not longer.
Variation less_share_along(const VectorAndLength& both, const std::array<double, 3>& direction);

/// Whether the vector, nearly at right angles to `axis`, is certainly shorter everywhere: in every
/// sector of directions, halving sectors until it is. Also ends, with false, when `is_found`
/// accepts a point of the box where the vector is longest within a sector.
bool is_shorter(const VectorAndLength& both, const std::array<double, 3>& axis,
                const std::function<bool(const std::vector<double>&)>& is_found);

}  // namespace raycheck::reference
