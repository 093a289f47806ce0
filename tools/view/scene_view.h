#pragma once

#include "properties/case.h"
#include "properties/run_control.h"
#include "properties/tally.h"
#include "tools/implementations/built_in.h"
#include "tools/view/document.h"
#include "tools/view/pictures/pictures.h"

namespace raycheck::tools {

/// Of the panels of all scenes of a page together.
inline constexpr std::size_t kPanelBytes = 720 << 10;

/// How much of a scene a page keeps.
struct PageLimits {
  std::size_t spheres = 10'000;           ///< Drawn in the figure.
  std::int64_t picture_pixels = 1 << 20;  ///< Of a picture; larger images are shown smaller.
  std::size_t panels = 4000;
  std::size_t panel_bytes = kPanelBytes;   ///< Of all panels, deflated.
  std::uint64_t answered_pairs = 1 << 24;  ///< Rays times spheres that are asked for pictures.
};

struct SceneViewOptions {
  std::string name;  ///< As commands and titles call it.
  std::string file;  ///< The scene as commands name it: a word, quoted where it has to be.
  std::string more_arguments;       ///< Of its commands: the candidate, or nothing.
  std::vector<MethodPair> methods;  ///< Whose pictures are shown; the rays are the first's.
  bool is_of_methods = false;       ///< Panels show the steps of those alone.
  /// Someone else's, by whose conventions all is shown; null: there is none.
  std::shared_ptr<const Implementation> other = nullptr;
  bool others_picture = true;  ///< Whether `other` is asked about every pixel.
  /// Someone else's renderer, whose picture is shown; empty: there is none.
  CandidateMaker renderer = {};
  /// What there has to be a panel of, the first selected at the start; empty: the middle.
  std::vector<Selection> wanted;
  PageLimits limits;
};

/// Has a view show an implementation, too: any number of methods, or one that is someone else's.
void show(const Implementation& implementation, SceneViewOptions& options);

/// A scene as a page shows it, and what was left out of it.
/// Throws std::invalid_argument naming the field where the scene is not valid or a selection is not
/// of it.
SceneView view_of(const scene::Scene& scene, const SceneViewOptions& options,
                  std::vector<std::string>& left_out, const properties::RunControl& control);

/// The ray and the sphere of a place in a scene; neither pixel nor ray where the place has none.
Selection selection_of(const properties::Place& place, const scene::Scene& scene);

/// Whether it says which ray is meant.
bool is_of_ray(const Selection& selection);

/// What a page of one case has to show: where it was found wrong, then all that the case looks at.
std::vector<Selection> selections_of(const properties::Case& the_case,
                                     const properties::Place& found);

}  // namespace raycheck::tools
