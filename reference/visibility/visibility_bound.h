#pragma once

// The terms of the bound of reference/visibility/visibility_kernel.h. Internal to reference/.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "reference/visibility/visibility_kernel.h"
#include "scene/plan/bounds.h"
#include "scene/plan/plan.h"

namespace raycheck::reference {

inline double middle(const scene::Bounds& x) { return x.low / 2 + x.high / 2; }

inline double half_width(const scene::Bounds& x) {
  return std::max(x.high - middle(x), middle(x) - x.low);
}

/// The sizes of the image plane in the filter's bound; the names are those of visibility_kernel.h.
struct PlaneSizes {
  double N = 0, X = 0, Y = 0;
  double delta = 0;
  double A = 0, E_a = 0;
};

PlaneSizes plane_sizes(const std::vector<scene::Bounds>& alpha,
                       const std::vector<scene::Bounds>& beta, const scene::Bounds& near);

/// A planned sphere for the filter; `exact` if the bound leaves the range of doubles.
FilteredSphere filtered(const scene::SpherePlan& plan, std::size_t index, const PlaneSizes& sizes);

}  // namespace raycheck::reference
