#ifndef RAYCHECK_REFERENCE_CONDITION_H_
#define RAYCHECK_REFERENCE_CONDITION_H_

#include "reference/exact_camera.h"
#include "reference/exact_ray.h"

namespace raycheck::reference {

// Upper estimates of condition numbers: the relative width that a value gains, per relative width
// given to every input at once. Balls of relative radius kConditionChange run through the one set
// of formulas; what they lose by forgetting that intermediate values depend on each other makes the
// estimate too large by a small factor, never too small (to first order). Infinite at a tangent.
inline constexpr double kConditionChange = 0x1p-60;

double condition_of_frame(const ExactCamera& camera);  ///< The worst axis.
double condition_of_pixel_point(const ExactRay& ray);
double condition_of_direction(const ExactRay& ray);
double condition_of_parameter(const ExactRay& ray, const scene::Sphere& sphere,
                              const Intersection& intersection);
double condition_of_point(const ExactRay& ray, const scene::Sphere& sphere,
                          const Intersection& intersection);

}  // namespace raycheck::reference

#endif  // RAYCHECK_REFERENCE_CONDITION_H_
