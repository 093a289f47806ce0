#pragma once

#include <optional>

#include "reference/exact_camera.h"
#include "reference/exact_ray.h"

namespace raycheck::reference {

// The condition number of a quantity q: sum over inputs x of |dq/dx| |x| / |q|; for a vector the
// sum of |dq/dx|_2 |x| / |q|_2. It is the relative change of q, to first order, per relative change
// of all inputs at once, with the worst choice of signs. Inputs: a given ray's 6 doubles, or a
// camera's eye, look_at, up, near, left, right, bottom and
//         top (14); and a sphere's 4. Indices and counts of pixels are not inputs.
// Units:  none.
// Domain: as ExactRay. Infinite where q = 0 and not all |dq/dx| |x| are certainly 0, and beyond the
//         doubles; 0 where q and all of them are 0 (a change of the inputs leaves q at 0).
// Error:  an upper bound, too large by at most kConditionWidth relatively or kNegligibleCondition.
// Source: derivatives by forward-mode automatic differentiation of reference/internal/formulas.h,
//         enclosed by intervals first, then by balls of growing precision.
inline constexpr double kConditionWidth = 0x1p-10;
inline constexpr double kNegligibleCondition = 0x1p-30;

double condition_of_frame(const ExactCamera& camera);  ///< The worst axis.
/// Only for a camera's ray.
double condition_of_pixel_point(const ExactRay& ray);
double condition_of_direction(const ExactRay& ray);
double condition_of_axial_distance(const ExactRay& ray, const scene::Sphere& sphere);
double condition_of_half_chord_sq(const ExactRay& ray, const scene::Sphere& sphere);
/// Of s and of Q. Both are infinite at an exact tangent, as is the derivative of sqrt(d^2).
/// Domain: `intersection` is what ray.intersect(sphere) found, a hit or a tangent.
double condition_of_parameter(const ExactRay& ray, const scene::Sphere& sphere,
                              const Intersection& intersection);
double condition_of_point(const ExactRay& ray, const scene::Sphere& sphere,
                          const Intersection& intersection);

// The condition numbers of single steps: of a step's result with respect to its direct operands,
// each taken as an independent input at its true value.

struct RayStageConditions {
  /// P = E + n W + alpha U + beta V by E, n, alpha, beta, U, V, W; empty for a given ray.
  std::optional<double> pixel_point;
  /// (P - E)/|P - E| by P and E; for a given ray its direction's normalisation.
  double direction = 0;
};
RayStageConditions stage_conditions(const ExactRay& ray);

struct SphereStageConditions {
  double axial_distance = 0;  ///< v = T.D/|D| by T and D
  double half_chord_sq = 0;   ///< d^2 = r^2 - |T x D|^2/|D|^2 by r, T and D
  /// v -+ sqrt(d^2) by v and d^2; empty for a miss. At a tangent 1: no relative change moves d^2
  /// from 0.
  std::optional<double> root;
  std::optional<double> point;  ///< L + s D by L, s and D; empty for a miss.
};
SphereStageConditions stage_conditions(const ExactRay& ray, const scene::Sphere& sphere,
                                       const Intersection& intersection);

/// How the textbook's formula, which is the lecture's, magnifies roundings: v = T.D,
/// d^2 = v^2 - |T|^2 + r^2, s = v -+ d, or the same as a quadratic equation. The condition number
/// of s with respect to T.D, v^2, |T|^2, r^2 and d as independent operands, the sum
/// (|T| + d + (2 |T||v| + |T|^2 + r^2) / 2d) / |s|.
/// Domain: as condition_of_parameter. Infinite at an exact tangent, and where s = 0.
double textbook_condition(const ExactRay& ray, const scene::Sphere& sphere,
                          const Intersection& intersection);

/// |T|/r, from the ray's origin to the sphere's centre, rounded up. Infinite for a point.
double distance_in_radii(const ExactRay& ray, const scene::Sphere& sphere);
/// |d^2|/r^2, rounded up. Infinite for a point.
double half_chord_share(const ExactRay& ray, const scene::Sphere& sphere);

/// For Q computed as L + s D, a step of every method that itself magnifies errors by |L|/|Q|: the
/// condition number of Q plus that of the step.
/// Domain: as condition_of_point.
double condition_of_computed_point(const ExactRay& ray, const scene::Sphere& sphere,
                                   const Intersection& intersection);

}  // namespace raycheck::reference
