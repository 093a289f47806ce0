#pragma once

#include "reference/exact_ray.h"
#include "tools/explain/explain.h"
#include "tools/report/json.h"
#include "tools/view/document.h"
#include "tools/view/figure/figure.h"
#include "tools/view/scene_view.h"

namespace raycheck::tools {

/// The panel of a ray and a sphere: the selected sphere; if none is selected, the sphere that the
/// ray meets first; if it meets none, the first in the file.
/// Domain: a valid scene and a selection of it; otherwise throws std::invalid_argument.
Panel panel_of(const scene::Scene& scene, const DrawnFrame& frame, const Selection& selection,
               const SceneViewOptions& options);

/// The answers of the report's intersection methods near the exact hit point or, if the exact
/// answer is a miss, near the ray's point closest to the centre, in the plane through the ray and
/// the centre. Null if no precision up to kMostMicroscopeBits suffices for the distances.
/// Units: ulp of that point's parameter, in doubles or, for an external single-precision candidate,
///        in floats; x along the ray, y from the ray towards the centre. Every coordinate is a
///        difference with a relative error of at most 2^-34.
/// Domain: a report about that ray and that sphere.
Json microscope_json(const ExplainReport& report, const reference::ExactRay& ray,
                     const scene::Sphere& sphere);

/// A remark after an s that is in multiples of a ray's direction; empty for unit directions.
std::string direction_remark(const ExplainReport& report);

}  // namespace raycheck::tools
