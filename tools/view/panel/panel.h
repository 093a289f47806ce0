#pragma once

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

}  // namespace raycheck::tools
