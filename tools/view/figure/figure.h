#pragma once

#include <string_view>
#include <vector>

#include "reference/exact_ray.h"
#include "tools/report/json.h"
#include "tools/view/document.h"
#include "tools/view/figure/drawn_frame.h"

namespace raycheck::tools {

/// What is drawn of a scene: at most `most_spheres` of its spheres.
/// Domain: a valid scene.
Figure figure_of(const scene::Scene& scene, std::size_t most_spheres);

/// What is drawn of one ray and a sphere (null: none) under the conventions of the scene.
PanelDrawing drawing_of(const DrawnFrame& frame, const reference::ExactRay& ray,
                        const scene::Sphere* sphere, const scene::Conventions& conventions);

/// What every figure draws between, at and beside named places.
Json parts_json();

/// What a scene's figure is drawn of.
Json figure_json(const SceneView& view);

Json drawing_json(const PanelDrawing& drawing);

// What figures draw between, at and beside the places that have a name: the same in every page. A
// part is drawn where all its places are there, and its layer is switched on.

/// From place to place.
struct PartLine {
  std::string_view layer;
  std::vector<std::string_view> path;
  std::string_view colour;
  bool is_thick = false, is_dashed = false, has_arrow = false;
};

struct PartMark {
  std::string_view layer, at, colour, shape;
  double size = 0;  ///< Pixels.
};

/// A name beside a place, or beside the middle of two.
struct PartName {
  std::string_view layer;
  std::vector<std::string_view> at;
  std::string_view text;  ///< Unless the place brings its own.
  std::string_view colour;
};

const std::vector<PartLine>& part_lines();
const std::vector<PartMark>& part_marks();
/// The most important first: the last are left out where there is no room.
const std::vector<PartName>& part_names();

}  // namespace raycheck::tools
