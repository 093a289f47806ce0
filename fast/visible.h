#pragma once

#include <optional>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "scene/plan/plan.h"
#include "scene/scene.h"

namespace raycheck::fast {

/// The nearest sphere at every pixel of a rectangle, by a method for rays and one for
/// intersections. Only spheres whose rectangle in the plan overlaps the given rectangle are tested.
/// Shape:  a rectangle of N pixels -> N answers, row by row; empty if a ray misses every sphere.
/// Units:  scene lengths.
/// Domain: a plan of `scene`, a rectangle inside its image, and a method that makes rays from the
///         plan's origin. A ray that is not finite or has the direction 0 misses every sphere.
/// Error:  that of the two methods; the plan adds no error.
std::vector<std::optional<FirstHit>> see(const scene::Scene& scene, const scene::ScenePlan& plan,
                                         const PixelRayMethod& rays,
                                         const IntersectMethod& intersect,
                                         const scene::PixelRectangle& pixels);

}  // namespace raycheck::fast
