#pragma once

#include "reference/exact_ray.h"
#include "tools/explain/explain.h"
#include "tools/report/json.h"
#include "tools/view/document.h"
#include "tools/view/figure/figure.h"
#include "tools/view/scene_view.h"

namespace raycheck::tools {

/// The panel of a ray and a sphere; by default the sphere that the ray meets first, or else the
/// first.
/// Domain: a valid scene and a selection of it; otherwise throws std::invalid_argument.
Panel panel_of(const scene::Scene& scene, const DrawnFrame& frame, const Selection& selection,
               const SceneViewOptions& options);

/// Where the answers of the report's intersection methods lie around the exact one: the
/// neighbourhood of the exact hit point, or of the ray's point nearest to the centre if the exact
/// answer is a miss, in the plane through the ray and the centre. Null if no precision up to
/// kMostMicroscopeBits suffices for the distances.
/// Units: ulp of that point's parameter, of doubles, or of floats for an external single-precision
///        candidate; x along the ray, y from the ray towards the centre. Every coordinate is a
///        difference, enclosed to a relative 2^-34.
/// Domain: a report about that ray and that sphere.
Json microscope_json(const ExplainReport& report, const reference::ExactRay& ray,
                     const scene::Sphere& sphere);

/// A remark appended to an s in multiples of a ray's direction; empty for unit directions.
std::string direction_remark(const ExplainReport& report);

}  // namespace raycheck::tools
