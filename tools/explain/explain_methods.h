#ifndef RAYCHECK_TOOLS_EXPLAIN_EXPLAIN_METHODS_H_
#define RAYCHECK_TOOLS_EXPLAIN_EXPLAIN_METHODS_H_

// The methods' side of `explain`. Internal to tools/explain/.

#include <vector>

#include "reference/closed_form.h"
#include "reference/exact_ray.h"
#include "tools/explain/explain.h"

namespace raycheck::tools {

/// The coordinates as a list.
template <class Triple>
std::vector<double> numbers(const Triple& value) {
  return {value.x, value.y, value.z};
}

/// The exact and symbolic sides of the ray that is explained.
struct Subject {
  reference::ExactRay exact;
  reference::ClosedFormRay symbolic;
  bool from_camera;
  double inherited_bound;  ///< What a hit's bound gains by its ray; 0 for a given ray.
};

/// Notes the condition numbers of the steps of a ray (`camera` null for a given one) and of a
/// sphere.
void add_ray_conditions(const Subject& subject, const reference::ExactCamera* camera,
                        std::vector<Step>& steps);
void add_sphere_conditions(const Subject& subject, const scene::Sphere& sphere,
                           const reference::Intersection& intersection, std::vector<Step>& steps);

/// A ray method's frame, pixel point and direction at one pixel.
MethodReport judge_rays(const fast::PixelRayMethod& method, const scene::Conventions& conventions,
                        const scene::Camera& camera, const scene::Pixel& pixel);

/// The ray that a method makes at a pixel, under the origin convention; throws
/// std::invalid_argument when it makes none.
scene::Ray ray_by(const fast::PixelRayMethod& method, const scene::Camera& camera,
                  const scene::Conventions& conventions, const scene::Pixel& pixel);

/// An intersection method on one ray. Its steps are placed by the exact answer for the very ray
/// that it was given; its answer is judged by the exact ray's.
MethodReport judge_intersection(const fast::IntersectMethod& method, const scene::Ray& ray,
                                const scene::Sphere& sphere, const scene::Conventions& conventions,
                                const Subject& subject, const SphereReport& exact);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXPLAIN_EXPLAIN_METHODS_H_
