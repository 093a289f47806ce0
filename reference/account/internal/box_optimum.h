#pragma once

// Linear programs over a box, with at most one equation or with several inequalities, in doubles:
// they guide the search and prove nothing. Internal to reference/.

#include <optional>
#include <vector>

namespace raycheck::reference {

/// value + sum_k slope_k t_k over the box [-1, 1]^n.
struct LinearForm {
  double value = 0;
  std::vector<double> slope;

  double at(const std::vector<double>& t) const;
};

/// A point of the box, and the multiplier that proves it optimal.
struct BoxOptimum {
  std::vector<double> t;
  double multiplier = 0;
};

/// Where a form is largest; t_k is 0 if it does not matter.
std::vector<double> highest(const LinearForm& f);

/// Where f is largest among the points of the box at which g = 0; empty if g has no zero there.
/// That value of f is also the maximum of f + multiplier g over the box.
/// Source: the dual's breakpoints, as in G. B. Dantzig's fractional knapsack.
std::optional<BoxOptimum> highest_where_zero(const LinearForm& f, const LinearForm& g);

/// A point of the box, and multipliers, not negative and summing to 1, that prove it optimal.
struct LeastOptimum {
  std::vector<double> t;
  double least = 0;  ///< The least of the forms there.
  std::vector<double> multipliers;
};

/// Where the minimum of one or more forms of equal dimension is largest; that minimum bounds the
/// sum of the forms, each times its multiplier, over the box.
/// Source: the simplex method with bounded variables (G. B. Dantzig).
LeastOptimum highest_least(const std::vector<LinearForm>& forms);

}  // namespace raycheck::reference
