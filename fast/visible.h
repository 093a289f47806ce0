#pragma once

#include <optional>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "scene/plan/plan.h"
#include "scene/scene.h"

namespace raycheck::fast {

/// The nearest sphere of every pixel of a rectangle, by any two methods: only the spheres whose
/// rectangle in the plan meets it are tested.
/// Shape:  a rectangle of N pixels -> N answers, row by row; empty where no sphere is met.
/// Units:  scene lengths.
/// Domain: a plan of this same scene, a rectangle inside its image; a method that makes rays from
///         the plan's origin. A ray that is not finite, or whose direction is 0, meets no sphere.
/// Error:  what the two methods promise; the plan adds none.
std::vector<std::optional<FirstHit>> see(const scene::Scene& scene, const scene::ScenePlan& plan,
                                         const PixelRayMethod& rays,
                                         const IntersectMethod& intersect,
                                         const scene::PixelRectangle& pixels);

}  // namespace raycheck::fast
