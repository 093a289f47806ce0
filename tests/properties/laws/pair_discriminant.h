#pragma once

#include "reference/visibility/visibility_pairs.h"

namespace raycheck::properties {

struct PairRoots {
  reference::Pair b, disc, q;
};

/// Of the first column and row, as the filter computes them on the target that Highway chooses; q
/// is 0 where disc is not above 0.
PairRoots pair_roots(const reference::FilteredSphereOf<reference::Pair>& sphere,
                     const reference::PairRays& rays);

}  // namespace raycheck::properties
