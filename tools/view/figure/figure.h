#pragma once

#include "reference/exact_ray.h"
#include "tools/view/document.h"
#include "tools/view/figure/drawn_frame.h"

namespace raycheck::tools {

/// What is drawn of a scene: at most `most_spheres` of its spheres.
/// Domain: a valid scene.
Figure figure_of(const scene::Scene& scene, std::size_t most_spheres);

/// What is drawn of one ray and a sphere (null: none) under the conventions of the scene.
PanelDrawing drawing_of(const DrawnFrame& frame, const reference::ExactRay& ray,
                        const scene::Sphere* sphere, const scene::Conventions& conventions);

}  // namespace raycheck::tools
