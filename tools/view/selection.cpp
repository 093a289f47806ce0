#include "tools/view/selection.h"

namespace raycheck::tools {

Selection selection_of(const properties::Place& place, const scene::Scene& scene) {
  Selection selection;
  if (scene.camera) {
    selection.pixel = place.pixel;
  } else {
    selection.ray = place.ray;
  }
  selection.sphere = place.sphere;
  return selection;
}

bool is_of_ray(const Selection& selection) { return selection.pixel || selection.ray; }

std::vector<Selection> selections_of(const properties::Case& the_case,
                                     const properties::Place& found) {
  std::vector<Selection> list;
  const Selection first = selection_of(found, the_case.scene);
  if (is_of_ray(first)) list.push_back(first);
  for (const scene::Pixel& pixel : the_case.pixels) list.push_back({pixel, {}, first.sphere});
  return list;
}

}  // namespace raycheck::tools
