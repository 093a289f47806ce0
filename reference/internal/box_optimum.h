#ifndef RAYCHECK_REFERENCE_INTERNAL_BOX_OPTIMUM_H_
#define RAYCHECK_REFERENCE_INTERNAL_BOX_OPTIMUM_H_

// Linear programs of at most one equation over a box, in doubles: where to look, which proves
// nothing. Internal to reference/.

#include <optional>
#include <vector>

namespace raycheck::reference {

/// value + sum_k slope_k t_k over the box [-1, 1]^n.
struct LinearForm {
  double value = 0;
  std::vector<double> slope;
};

/// A point of the box, and the multiplier that proves it optimal.
struct BoxOptimum {
  std::vector<double> t;
  double multiplier = 0;
};

/// Where a form is largest; 0 in each t_k that does not matter.
std::vector<double> highest(const LinearForm& f);

/// Where f is largest among the points of the box at which g = 0; empty where there is none. f +
/// multiplier g is nowhere in the box larger than f is there.
/// Source: the dual's breakpoints, as in G. B. Dantzig's fractional knapsack.
std::optional<BoxOptimum> highest_where_zero(const LinearForm& f, const LinearForm& g);

}  // namespace raycheck::reference

#endif  // RAYCHECK_REFERENCE_INTERNAL_BOX_OPTIMUM_H_
