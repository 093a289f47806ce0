#pragma once

#include "reference/exact_ray.h"
#include "tools/report/json.h"
#include "tools/view/document.h"
#include "tools/view/figure/figure.h"

namespace raycheck::tools {

/// Whose steps panels show besides those of raycheck's methods, and the words for explain.
struct PanelOptions {
  const fast::PixelRayMethod* rays = kDefaultMethods.rays;
  std::shared_ptr<const Implementation> other = nullptr;
  std::vector<MethodPair> methods = {};  ///< Show only their steps; empty: all.
  std::string scene_argument;  ///< The scene as a word of a command; unused for given rays.
  std::string more_arguments;  ///< For commands: the candidate, or empty.
};

/// The panel of a ray and a sphere; by default the sphere that the ray meets first, or else the
/// first.
/// Domain: a valid scene and a selection of it; otherwise throws std::invalid_argument.
Panel panel_of(const scene::Scene& scene, const DrawnFrame& frame, const Selection& selection,
               const PanelOptions& options);

/// Whether a step's closed form is short enough to be typeset: explain's text cuts longer ones,
/// too.
bool is_typeset(const Step& step);

/// Where the answers of the report's intersection methods lie around the exact one. Empty if no
/// precision up to kMostMicroscopeBits suffices for the distances.
/// Domain: a report about that ray and that sphere.
std::optional<Microscope> microscope_of(const ExplainReport& report, const reference::ExactRay& ray,
                                        const scene::Sphere& sphere);

/// The format whose ulp is the unit: double, or float for an external single-precision candidate.
scene::Precision microscope_precision(const ExplainReport& report);

/// Lengths from 2^-1074 to 2^1024 in one scene need some 2,100 bits, and as many again cancel.
inline constexpr int kMostMicroscopeBits = 6144;

/// A number with 17 significant digits.
std::string digits_text(double value);

/// For a ray and a sphere: the steps, each method's answer, and the exact one. Rich text is a list
/// of [kind, text]: "", "symbol", "number", "mark" (wrong digits) or "wrong".
Json told_json(const ExplainReport& report);

Json microscope_json(const Microscope& microscope);

/// SageMath code that computes the same steps exactly: the inputs as rationals, then the formulas
/// of docs/problem.md.
std::string sage_input(const ExplainReport& report);

/// Appended to an s in multiples of a ray's direction; empty for unit directions.
std::string direction_remark(const ExplainReport& report);

/// What the microscope shows: around which point, in what unit, how far answers to a miss are, and
/// which methods cannot be drawn.
std::vector<std::string> microscope_sentences(const Microscope& microscope,
                                              const ExplainReport& report, double gap);

}  // namespace raycheck::tools
