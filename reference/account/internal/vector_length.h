#pragma once

// How long a vector is that varies over a box, by its shares along directions: they are linear in
// the inputs where its square is not. Internal to reference/.

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
/// What is not negative where the vector is at most as long: that less its share along a direction.
Variation less_share_along(const VectorAndLength& both, const std::array<double, 3>& direction);

/// Whether the vector, which is nearly at right angles to `axis`, is certainly shorter, everywhere:
/// in each of some sectors of directions, which are halved until it is. Ends, too, with false, when
/// `is_found` says so of a point of the box where the vector is as long in a sector as it gets.
bool is_shorter(const VectorAndLength& both, const std::array<double, 3>& axis,
                const std::function<bool(const std::vector<double>&)>& is_found);

}  // namespace raycheck::reference
