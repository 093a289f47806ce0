#pragma once

#include <optional>

#include "reference/exact_camera.h"
#include "reference/exact_ray.h"

namespace raycheck::reference {

// The condition number of a quantity q is the sum over inputs x of |dq/dx| |x| / |q|; for a vector,
// the sum of |dq/dx|_2 |x| / |q|_2. To first order, it is the largest relative change of q, divided
// by the relative change of all inputs, over all choices of signs.
// Inputs: a given ray's 6 doubles, or a camera's eye, look_at, up, near, left, right, bottom and
//         top (14); and a sphere's 4. Indices and numbers of pixels are not inputs.
// Units:  none.
// Domain: that of ExactRay. If q = 0, the result is 0 if all |dq/dx| |x| are certainly 0, otherwise
//         infinite. It is infinite, too, beyond the largest double.
// Error:  an upper bound, too large by at most the share kConditionWidth or by
//         kNegligibleCondition.
// Source: derivatives by forward-mode automatic differentiation of reference/internal/formulas.h,
//         enclosed by intervals first, then by balls of growing precision.
inline constexpr double kConditionWidth = 0x1p-10;
inline constexpr double kNegligibleCondition = 0x1p-30;

double condition_of_frame(const ExactCamera& camera);  ///< The largest of an axis.
/// Domain: a camera's ray.
double condition_of_pixel_point(const ExactRay& ray);
/// A much cheaper upper bound of condition_of_pixel_point(); infinite if double-doubles give none.
/// With w = E - A, u = up x w and g = P - E, a change of the inputs turns the axes by at most
/// |dw|/|w| + |du|/|u|, so that the bound is |E| + |g| ((|E| + |A|) (1/|w| + |up|/|u|) +
/// |up||w|/|u|)
/// + |n| + |left| + |right| + |bottom| + |top| over |P|, where |E|, |A| and the first |up| of a
/// product are sums of the coordinates' magnitudes.
double most_condition_of_pixel_point(const ExactRay& ray);
double condition_of_direction(const ExactRay& ray);
double condition_of_axial_distance(const ExactRay& ray, const scene::Sphere& sphere);
double condition_of_half_chord_sq(const ExactRay& ray, const scene::Sphere& sphere);
/// The condition numbers of s and Q; infinite at an exact tangent, as the derivative of sqrt(d^2)
/// is.
/// Domain: `intersection` is the result of ray.intersect(sphere), a hit or a tangent.
double condition_of_parameter(const ExactRay& ray, const scene::Sphere& sphere,
                              const Intersection& intersection);
double condition_of_point(const ExactRay& ray, const scene::Sphere& sphere,
                          const Intersection& intersection);

// The condition numbers of single steps. The inputs are the direct operands of the step,
// independent of each other and exact.

struct RayStageConditions {
  /// P = E + n W + alpha U + beta V. Inputs: E, n, alpha, beta, U, V, W. Empty for a given ray.
  std::optional<double> pixel_point;
  /// (P - E)/|P - E|. Inputs: P, E. For a given ray, the normalisation of its direction.
  double direction = 0;
};
RayStageConditions stage_conditions(const ExactRay& ray);

struct SphereStageConditions {
  double axial_distance = 0;  ///< v = T.D/|D|. Inputs: T, D.
  double half_chord_sq = 0;   ///< d^2 = r^2 - |T x D|^2/|D|^2. Inputs: r, T, D.
  /// v -+ sqrt(d^2). Inputs: v, d^2. Empty for a miss. 1 at a tangent, since no relative change
  /// moves d^2 away from 0.
  std::optional<double> root;
  std::optional<double> point;  ///< L + s D. Inputs: L, s, D. Empty for a miss.
};
SphereStageConditions stage_conditions(const ExactRay& ray, const scene::Sphere& sphere,
                                       const Intersection& intersection);

/// The factor by which the formula of textbooks and the lecture magnifies rounding errors: v = T.D,
/// d^2 = v^2 - |T|^2 + r^2, s = v -+ d, or the same as a quadratic equation. It is the condition
/// number of s with T.D, v^2, |T|^2, r^2 and d as independent inputs, the sum
/// (|T| + d + (2 |T||v| + |T|^2 + r^2) / 2d) / |s|.
/// Domain: that of condition_of_parameter. Infinite at an exact tangent or if s = 0.
double textbook_condition(const ExactRay& ray, const scene::Sphere& sphere,
                          const Intersection& intersection);

/// |T|/r, rounded up. Infinite if r = 0.
double distance_in_radii(const ExactRay& ray, const scene::Sphere& sphere);
/// |d^2|/r^2, rounded up. Infinite if r = 0.
double half_chord_share(const ExactRay& ray, const scene::Sphere& sphere);

/// The condition number of Q plus that of the step L + s D. Every method computes Q by this step,
/// which magnifies errors by |L|/|Q|.
/// Domain: that of condition_of_point.
double condition_of_computed_point(const ExactRay& ray, const scene::Sphere& sphere,
                                   const Intersection& intersection);

}  // namespace raycheck::reference
