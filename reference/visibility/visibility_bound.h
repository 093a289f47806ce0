#pragma once

// The terms of the bound of reference/visibility/visibility_kernel.h. Internal to reference/.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "reference/visibility/visibility_kernel.h"
#include "scene/plan/bounds.h"
#include "scene/plan/plan.h"

namespace raycheck::reference {

// In units of u0; proofs/ proves them for the formulas, fused or not.
inline constexpr double kSumRoundings = 5;        ///< Of b and a, of B and A.
inline constexpr double kDiscRoundings = 3.1;     ///< Of b^2 - c a, of B^2 + |c| A.
inline constexpr double kMomentRoundings = 3;     ///< Of a component of f x g, of P_k.
inline constexpr double kByMomentRoundings = 33;  ///< Of r^2 a - |f x g|^2, of S^2.
// The other factors of the bound, proved by proofs/identities/filter_*.smt2.
inline constexpr double kSquareShare = 2.2;   ///< Of B E_b: the error of b^2 that b's causes.
inline constexpr double kProductShare = 1.1;  ///< Of |c| E_a and rho_c A, likewise c a.
inline constexpr double kLeastMoment = 8;     ///< By moment only where S/e is at least this.
inline constexpr double kRootShare = 0.51;    ///< Of sqrt(E/kDecidedBeyond), likewise q.
/// Covers rounding errors in computing bounds, and terms of second order.
inline constexpr double kSlack = 1.01;

inline double middle(const scene::Bounds& x) { return x.low / 2 + x.high / 2; }

inline double half_width(const scene::Bounds& x) {
  return std::max(x.high - middle(x), middle(x) - x.low);
}

/// The sizes of the image plane in the filter's bound; the names are those of visibility_kernel.h.
struct PlaneSizes {
  double u0 = 0x1p-53;
  double N = 0, X = 0, Y = 0;
  double delta = 0;
  double A = 0, E_a = 0;

  /// Sets A and E_a by the rest.
  void set_squares();
};

PlaneSizes plane_sizes(const std::vector<scene::Bounds>& alpha,
                       const std::vector<scene::Bounds>& beta, const scene::Bounds& near);

/// The uncertainties of a sphere's numbers.
struct SphereDoubt {
  double rho = 0, rho_c = 0, rho_r = 0;
};

/// The bounds of a sphere in the filter.
struct SphereBound {
  double E_b = 0, roots = 0;  ///< The terms of E_m.
  double by_roots = 0, by_moment = 0;
  bool has_moment = false;  ///< |h^| cannot exceed 2 S where the line meets the sphere.

  double root_margin(double E) const;
};
SphereBound bound_of(const FilteredSphere& sphere, const SphereDoubt& doubt,
                     const PlaneSizes& sizes);

/// Sets a sphere's bounds, E being one of them; `exact` if they leave the range of doubles.
template <class Number>
void set_bound(const SphereBound& bound, bool by_moment, FilteredSphereOf<Number>& sphere) {
  const double E = by_moment ? bound.by_moment : bound.by_roots;
  sphere.by_moment = by_moment;
  sphere.decided = kDecidedBeyond * E;
  sphere.root_margin = bound.root_margin(E);
  sphere.exact = !(E >= kLeastBound && sphere.decided <= kLargestBound);
}

/// A planned sphere for the filter.
FilteredSphere filtered(const scene::SpherePlan& plan, std::size_t index, const PlaneSizes& sizes);

}  // namespace raycheck::reference
