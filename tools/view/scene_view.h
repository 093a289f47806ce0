#pragma once

#include "properties/case.h"
#include "properties/decision.h"
#include "properties/run_control.h"
#include "tools/implementations/built_in.h"
#include "tools/view/document.h"
#include "tools/view/pictures/pictures.h"

namespace raycheck::tools {

/// For the panels of all scenes of a page together.
inline constexpr std::size_t kPanelBytes = 720 << 10;

/// Limits on the contents of a page.
struct PageLimits {
  std::size_t spheres = 10'000;           ///< Drawn in the figure.
  std::int64_t picture_pixels = 1 << 20;  ///< Of a picture; larger images are reduced.
  std::size_t panels = 4000;
  std::size_t panel_bytes = kPanelBytes;   ///< Of all panels, deflated.
  std::uint64_t answered_pairs = 1 << 24;  ///< Rays times spheres asked for pictures.
};

struct SceneViewOptions {
  std::string name;                 ///< For commands and titles.
  std::string file;                 ///< The scene as a word of commands, quoted if necessary.
  std::string more_arguments;       ///< For its commands: the candidate, or empty.
  std::vector<MethodPair> methods;  ///< Show their pictures, with the first one's rays.
  bool is_of_methods = false;       ///< Panels show only their steps.
  /// An external implementation, whose conventions all views use; or null.
  std::shared_ptr<const Implementation> other = nullptr;
  bool others_picture = true;  ///< Whether `other` is asked about every pixel.
  /// An external renderer, whose picture is shown; or empty.
  CandidateMaker renderer = {};
  /// The required panels, the first selected at the start; empty: the middle.
  std::vector<Selection> wanted;
  PageLimits limits;
};

/// Adds a candidate to a view: any number of methods, or one external candidate.
void show(const Implementation& implementation, SceneViewOptions& options);

/// A scene as a page shows it, and what was left out of it. Throws std::invalid_argument naming the
/// field if the scene is invalid or a selection is not part of it.
SceneView view_of(const scene::Scene& scene, const SceneViewOptions& options,
                  std::vector<std::string>& left_out, const properties::RunControl& control);

/// The ray and the sphere of a place in a scene; without pixel and ray if the place has neither.
Selection selection_of(const properties::Place& place, const scene::Scene& scene);

/// Whether a selection determines a ray.
bool is_of_ray(const Selection& selection);

/// The selections that a page of one case must show: the wrong place, then all others of the case.
std::vector<Selection> selections_of(const properties::Case& the_case,
                                     const properties::Place& found);

}  // namespace raycheck::tools
