#pragma once

// Linear programs over a box, with at most one equation or with several inequalities, in doubles.
// They guide the search and prove nothing. Internal to reference/.

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

/// The point where a form is largest; t_k is 0 if the form does not depend on it.
std::vector<double> highest(const LinearForm& f);

/// The point where f is largest among the points of the box with g = 0; empty if there are none.
/// The value of f there is also the maximum of f + multiplier g over the box.
/// Source: the dual's breakpoints, as in G. B. Dantzig's fractional knapsack.
std::optional<BoxOptimum> highest_where_zero(const LinearForm& f, const LinearForm& g);

/// A point of the box, and the multipliers that prove it optimal. They are not negative, and their
/// sum is 1.
struct LeastOptimum {
  std::vector<double> t;
  double least = 0;  ///< The least of the forms at the point.
  std::vector<double> multipliers;
};

/// The point where the minimum of one or more forms of equal dimension is largest. This minimum is
/// an upper bound, over the box, on the sum of the forms, each times its multiplier.
/// Source: the simplex method with bounded variables (G. B. Dantzig).
LeastOptimum highest_least(const std::vector<LinearForm>& forms);

}  // namespace raycheck::reference
