#pragma once

#include "reference/exact_ray.h"
#include "tools/report/json.h"
#include "tools/view/document.h"
#include "tools/view/figure/figure.h"

namespace raycheck::tools {

/// Whose steps panels show besides those of raycheck's methods, and how explain is asked the same.
struct PanelOptions {
  const fast::PixelRayMethod* rays = kDefaultMethods.rays;
  std::shared_ptr<const Implementation> other = nullptr;
  std::vector<MethodPair> methods = {};  ///< Whose steps alone are shown; empty: everyone's.
  std::string scene_argument;  ///< The scene as a word of a command; of given rays it is not used.
  std::string more_arguments;  ///< Of commands: the candidate, or nothing.
};

/// All that is said about one ray and a sphere; without one about that which the ray meets first,
/// or else the first.
/// Domain: a valid scene and a selection of it; otherwise throws std::invalid_argument.
Panel panel_of(const scene::Scene& scene, const DrawnFrame& frame, const Selection& selection,
               const PanelOptions& options);

/// Whether a step's closed form is short enough to be typeset: explain's text cuts longer ones,
/// too.
bool is_typeset(const Step& step);

/// Where the answers of the report's intersection methods lie around the exact one. Empty where no
/// precision up to kMostMicroscopeBits tells the distances.
/// Domain: a report about that ray and that sphere.
std::optional<Microscope> microscope_of(const ExplainReport& report, const reference::ExactRay& ray,
                                        const scene::Sphere& sphere);

/// Whose ulp is counted in: the double's, or of someone else's single-precision candidate the
/// float's.
scene::Precision microscope_precision(const ExplainReport& report);

/// Lengths from 2^-1074 to 2^1024 in one scene need some 2,100 bits, and as many again cancel.
inline constexpr int kMostMicroscopeBits = 6144;

/// A number that is told, to 17 significant digits.
std::string digits_text(double value);

/// Of a ray and a sphere: the steps, what each method comes to, and the exact answer. A text that
/// is more than plain is a list of [kind, text]: "", "symbol", "number", "mark" (digits that are
/// wrong) or "wrong".
Json told_json(const ExplainReport& report);

Json microscope_json(const Microscope& microscope);

/// What SageMath computes the same steps from, exactly: the inputs as rationals, then the formulas
/// of docs/problem.md.
std::string sage_input(const ExplainReport& report);

/// Behind an s that counts multiples of a ray's direction; nothing where that is a unit vector.
std::string direction_remark(const ExplainReport& report);

/// What the microscope shows: around which point, in what unit, how far away the answers to a miss
/// are, and of which methods there is nothing to draw.
std::vector<std::string> microscope_sentences(const Microscope& microscope,
                                              const ExplainReport& report, double gap);

}  // namespace raycheck::tools
