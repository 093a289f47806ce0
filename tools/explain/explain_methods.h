#pragma once

// The methods' side of `explain`. Internal to tools/explain/.

#include <optional>
#include <string>
#include <vector>

#include "reference/account/closed_form.h"
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

/// Someone else's steps, as far as it offers them: of a pixel, and of the ray that intersection
/// methods are given. Where it gives no answer, the report says how.
MethodReport judge_others_rays(const properties::Candidate& candidate,
                               const scene::Conventions& conventions, const scene::Camera& camera,
                               const scene::Pixel& pixel);
MethodReport judge_others_intersection(const properties::Candidate& candidate,
                                       const scene::Ray& ray, const scene::Sphere& sphere,
                                       const scene::Conventions& conventions,
                                       const Subject& subject, const SphereReport& exact);

/// A step of a method, wrong where its error is above the bound. Both count the unit of a quantity
/// in the format that the method is judged in.
MethodStep step(const char* symbol, std::vector<double> value, std::optional<double> error,
                double bound, properties::Quantity quantity,
                scene::Precision precision = scene::Precision::kDouble);
/// The first step off by more than its bound, in a method whose answer is wrong; where none alone
/// is, the last one, to which small errors add up.
std::string first_wrong(const MethodReport& report);

/// The ray that a method makes at a pixel, under the origin convention; throws
/// std::invalid_argument when it makes none.
scene::Ray ray_by(const fast::PixelRayMethod& method, const scene::Camera& camera,
                  const scene::Conventions& conventions, const scene::Pixel& pixel);

/// What an intersection method answered about one ray, and what it is held to.
struct RayAnswered {
  std::string name;
  std::optional<fast::Hit> hit;  ///< Empty: a miss.
  std::optional<fast::Roots> roots = {};
  double max_ulp, max_point_ulp, unit_roundoff;
  bool tells_roots_alone = false;  ///< Nothing of how it came to them, not even T.
  scene::Precision precision = scene::Precision::kDouble;  ///< What its errors and bounds count.
};

/// The answer's steps and verdict, as judge_intersection has them, under conventions that are its
/// own: `exact` is what these make of the sphere.
/// Domain: a valid ray.
MethodReport judge_answer(const RayAnswered& answer, const scene::Ray& ray,
                          const scene::Sphere& sphere, const scene::Conventions& conventions,
                          const Subject& subject, const SphereReport& exact);

/// An intersection method on one ray. Its steps are placed by the exact answer for the very ray
/// that it was given; its answer is judged by the exact ray's.
MethodReport judge_intersection(const fast::IntersectMethod& method, const scene::Ray& ray,
                                const scene::Sphere& sphere, const scene::Conventions& conventions,
                                const Subject& subject, const SphereReport& exact);

}  // namespace raycheck::tools
