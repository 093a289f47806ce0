#pragma once

// Bounds the length of a vector that varies over a box by its components along directions, since
// these are linear in the inputs, while the square of the length is not. Internal to reference/.

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

/// A point of the box where the vector is about as short as possible, and its direction there.
struct Shortest {
  std::vector<double> t;
  std::array<double, 3> direction;
};
Shortest shortest(const VectorAndLength& both);
/// The length minus the vector's component along a direction; >= 0 if the vector is not longer.
Variation less_share_along(const VectorAndLength& both, const std::array<double, 3>& direction);

/// Whether the vector, which is nearly at right angles to `axis`, is certainly shorter everywhere.
/// A sector of directions for which this is not certain is halved. Ends with false if `is_found`
/// accepts a point of the box where the vector is longest within a sector.
bool is_shorter(const VectorAndLength& both, const std::array<double, 3>& axis,
                const std::function<bool(const std::vector<double>&)>& is_found);

}  // namespace raycheck::reference
