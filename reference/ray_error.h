#pragma once

#include <optional>

#include "reference/exact_ray.h"
#include "scene/geometry.h"

namespace raycheck::reference {

// The errors of given answers about one ray: the measures of reference/error_measure.h against an
// ExactRay.
// Units:  u of doubles; for the parameter ulp of the format asked for.
// Domain: as ExactRay; `intersection` is what ray.intersect(sphere) found, a hit or a tangent.
//         Infinite for an answer that is not finite.
// Error:  upper bounds: by double-doubles where these enclose the error to a relative 2^-30,
//         otherwise by balls around values of ExactRay::kValueBits.

scene::Measured pixel_point_error(const ExactRay& ray, const scene::Point3& given);
scene::Measured origin_error(const ExactRay& ray, const scene::Point3& given);
/// The angle (angle_error).
scene::Measured direction_error(const ExactRay& ray, const scene::UnitVector3& given);
scene::Measured parameter_error(const ExactRay& ray, const scene::Sphere& sphere,
                                const Intersection& intersection, double given,
                                scene::Precision precision = scene::Precision::kDouble);
scene::Measured hit_point_error(const ExactRay& ray, const scene::Sphere& sphere,
                                const Intersection& intersection, const scene::Point3& given);

/// Distance of a point from the sphere over r; empty where r is 0.
std::optional<scene::Measured> sphere_residual(const scene::Sphere& sphere,
                                               const scene::Point3& given);
/// Distance of a point from the ray's line over its distance from the origin; empty where that may
/// be 0.
std::optional<scene::Measured> ray_residual(const ExactRay& ray, const scene::Point3& given);

/// Whether a parameter is certainly within 1/kOtherRootShare of the roots' distance of the root
/// other than `intersection`'s: between the two it is an error, not the other root.
bool is_at_other_root(const ExactRay& ray, const scene::Sphere& sphere,
                      const Intersection& intersection, double given);
inline constexpr int kOtherRootShare = 4;  ///< One over the share.

}  // namespace raycheck::reference
