#pragma once

#include <optional>

#include "reference/exact_ray.h"
#include "scene/geometry.h"

namespace raycheck::reference {

// The errors of given answers for one ray, by the measures of reference/error_measure.h and
// ExactRay.
// Units:  u of doubles; for the parameter, ulp of the given format.
// Domain: that of ExactRay. `intersection` is the result of ray.intersect(sphere), a hit or a
//         tangent. The error of an answer that is not finite is infinite.
// Error:  upper bounds: by double-doubles if these enclose the error to a relative 2^-30, otherwise
//         by balls around values of ExactRay::kValueBits.

scene::Measured pixel_point_error(const ExactRay& ray, const scene::Point3& given);
scene::Measured origin_error(const ExactRay& ray, const scene::Point3& given);
/// The angle between the directions (see angle_error).
scene::Measured direction_error(const ExactRay& ray, const scene::UnitVector3& given);
scene::Measured parameter_error(const ExactRay& ray, const scene::Sphere& sphere,
                                const Intersection& intersection, double given,
                                scene::Precision precision = scene::Precision::kDouble);
scene::Measured hit_point_error(const ExactRay& ray, const scene::Sphere& sphere,
                                const Intersection& intersection, const scene::Point3& given);

/// Values of a ray and its hit in double-doubles, for errors that relate several answers.
struct HitInDoubleDoubles {
  DoubleDouble length;  ///< See EnclosedRay, as for the others.
  DoubleDouble parameter;
  Triple<DoubleDouble> origin, point;
};
HitInDoubleDoubles hit_in_double_doubles(const ExactRay& ray, const scene::Sphere& sphere,
                                         const Intersection& intersection);

/// The distance of a point from the sphere, divided by r; empty if r is 0.
std::optional<scene::Measured> sphere_residual(const scene::Sphere& sphere,
                                               const scene::Point3& given);
/// The distance of a point from the ray's line, divided by its distance from the origin; empty if
/// the divisor may be 0.
std::optional<scene::Measured> ray_residual(const ExactRay& ray, const scene::Point3& given);

/// Whether the distance of a parameter from the other root, not that of `intersection`, is
/// certainly at most 1/kOtherRootShare of the distance of the roots. A parameter between the roots
/// is an error.
bool is_at_other_root(const ExactRay& ray, const scene::Sphere& sphere,
                      const Intersection& intersection, double given);
inline constexpr int kOtherRootShare = 4;  ///< One over the share.

}  // namespace raycheck::reference
