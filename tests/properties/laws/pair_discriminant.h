#pragma once

#include "reference/visibility/visibility_pairs.h"

namespace raycheck::properties {

struct PairRoots {
  reference::Pair b, disc, q;
};

/// The values of the first column and row, as the filter computes them on Highway's target. q is 0
/// if disc is not above 0.
PairRoots pair_roots(const reference::FilteredSphereOf<reference::Pair>& sphere,
                     const reference::PairRays& rays);

}  // namespace raycheck::properties
