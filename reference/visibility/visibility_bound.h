#pragma once

// The terms of the bound of reference/visibility/visibility_kernel.h. Internal to reference/.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "reference/visibility/visibility_kernel.h"
#include "scene/plan/bounds.h"
#include "scene/plan/plan.h"

namespace raycheck::reference {

// Rounding errors, proved by proofs/ for the formulas, fused or not.
inline constexpr double kSumRoundings = 5;        ///< b: in u0 B; a: in u0 A.
inline constexpr double kDiscRoundings = 3.1;     ///< b^2 - c a: in u0 (B^2 + |c| A).
inline constexpr double kMomentRoundings = 3;     ///< A component of f x g: in u0 P_k.
inline constexpr double kByMomentRoundings = 33;  ///< r^2 a - |f x g|^2: in u0 S^2.
// The other factors of the bound, proved by proofs/identities/filter_*.smt2.
inline constexpr double kSquareShare = 2.2;   ///< The error of b^2 from that of b: in B E_b.
inline constexpr double kProductShare = 1.1;  ///< That of c a from a and c: in |c| E_a, rho_c A.
inline constexpr double kLeastMoment = 8;     ///< The form with h is used only if S/e >= this.
inline constexpr double kRootShare = 0.51;    ///< That of q: in sqrt(E/kDecidedBeyond).
/// Covers rounding errors in computing bounds, and terms of second order.
inline constexpr double kSlack = 1.01;

inline double middle(const scene::Bounds& x) { return x.low / 2 + x.high / 2; }

inline double half_width(const scene::Bounds& x) {
  return std::max(x.high - middle(x), middle(x) - x.low);
}

/// The sizes of the image plane in the filter's bound, with the names of visibility_kernel.h.
struct PlaneSizes {
  double u0 = 0x1p-53;
  double N = 0, X = 0, Y = 0;
  double delta = 0;
  double A = 0, E_a = 0;

  /// Computes A and E_a from the other members.
  void set_squares();
};

PlaneSizes plane_sizes(const std::vector<scene::Bounds>& alpha,
                       const std::vector<scene::Bounds>& beta, const scene::Bounds& near);

/// Bounds on the errors of a sphere's numbers.
struct SphereDoubt {
  double rho = 0, rho_c = 0, rho_r = 0;
};

/// The filter's error bounds for a sphere.
struct SphereBound {
  double E_b = 0, roots = 0;  ///< Terms of E_m.
  double by_roots = 0, by_moment = 0;
  bool has_moment = false;  ///< |h^| is at most 2 S if the line meets the sphere.

  double root_margin(double E) const;
};
SphereBound bound_of(const FilteredSphere& sphere, const SphereDoubt& doubt,
                     const PlaneSizes& sizes);

/// Sets a sphere's bounds, for one of the two forms; sets `exact` if they are out of range.
template <class Number>
void set_bound(const SphereBound& bound, bool by_moment, FilteredSphereOf<Number>& sphere) {
  const double E = by_moment ? bound.by_moment : bound.by_roots;
  sphere.by_moment = by_moment;
  sphere.decided = kDecidedBeyond * E;
  sphere.root_margin = bound.root_margin(E);
  sphere.exact = !(E >= kLeastBound && sphere.decided <= kLargestBound);
}

/// A planned sphere as the filter stores it.
FilteredSphere filtered(const scene::SpherePlan& plan, std::size_t index, const PlaneSizes& sizes);

}  // namespace raycheck::reference
