#pragma once

#include <vector>

#include "reference/exact_ray.h"
#include "tools/report/json.h"
#include "tools/view/document.h"
#include "tools/view/figure/drawn_frame.h"

namespace raycheck::tools {

/// The data from which a scene's figure is drawn, with at most `most_spheres` of its spheres. Every
/// coordinate is computed exactly, relative to the eye or to the first given ray's origin, scaled
/// by a power of two and rounded once. The frustum's corners follow from the rounded axes and are
/// off by at most 8u of their distance. `seen`: the nearest spheres of the pixels, in order; empty
/// if unknown.
/// Domain: a valid scene.
Json figure_json(const scene::Scene& scene, std::size_t most_spheres,
                 const std::vector<SeenRun>& seen);

/// The drawing of a ray and a sphere (or null) under the scene's conventions.
Json drawing_json(const DrawnFrame& frame, const reference::ExactRay& ray,
                  const scene::Sphere* sphere, const scene::Conventions& conventions);

/// The parts that figures have between, at and beside named places. A part is drawn if all its
/// places exist and its layer is switched on.
Json parts_json();

}  // namespace raycheck::tools
