#pragma once

#include "properties/case.h"
#include "properties/decision.h"
#include "properties/run_control.h"
#include "tools/implementations/built_in.h"
#include "tools/view/document.h"
#include "tools/view/pictures/pictures.h"

namespace raycheck::tools {

/// The limit for the panels of all scenes of a page together.
inline constexpr std::size_t kPanelBytes = 720 << 10;

/// Limits on the contents of a page.
struct PageLimits {
  std::size_t spheres = 10'000;           ///< The number drawn in the figure.
  std::int64_t picture_pixels = 1 << 20;  ///< The pixels of a picture; larger images are reduced.
  std::size_t panels = 4000;
  std::size_t panel_bytes = kPanelBytes;  ///< The size of all panels, deflated.
  /// The number of pairs of a ray and a sphere asked for pictures.
  std::uint64_t answered_pairs = 1 << 24;
};

struct SceneViewOptions {
  std::string name;            ///< The scene's name in commands and titles.
  std::string file;            ///< The scene file as a word of commands, quoted if necessary.
  std::string more_arguments;  ///< The options of commands for the candidate, or empty.
  /// The methods whose pictures are shown, with the rays of the first.
  std::vector<MethodPair> methods;
  bool is_of_methods = false;  ///< Whether panels show only the steps of these methods.
  /// An external implementation, or null. All views use its conventions.
  std::shared_ptr<const Implementation> other = nullptr;
  bool others_picture = true;  ///< Whether `other` is asked about every pixel.
  /// An external renderer whose picture is shown, or empty.
  CandidateMaker renderer = {};
  /// The required panels; the first is selected at the start. If empty, the middle is selected.
  std::vector<Selection> wanted;
  PageLimits limits;
};

/// Adds an implementation to a view, which shows any number of methods, or one external candidate.
void show(const Implementation& implementation, SceneViewOptions& options);

/// A scene as a page shows it; adds what did not fit to `left_out`. Throws std::invalid_argument
/// naming the field if the scene is invalid or a selection is not part of it.
SceneView view_of(const scene::Scene& scene, const SceneViewOptions& options,
                  std::vector<std::string>& left_out, const properties::RunControl& control);

/// The selection of a place in a scene; without pixel and ray if the place has neither.
Selection selection_of(const properties::Place& place, const scene::Scene& scene);

/// Whether a selection determines a ray.
bool is_of_ray(const Selection& selection);

/// The selections that a page of one case must show: the wrong place first, then all others.
std::vector<Selection> selections_of(const properties::Case& the_case,
                                     const properties::Place& found);

}  // namespace raycheck::tools
