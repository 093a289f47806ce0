#include "properties/mistakes/shown_picture.h"

#include <utility>

#include "properties/failures.h"
#include "reference/visibility/visibility.h"
#include "scene/plan/plan.h"

namespace raycheck::properties {

ImageAnswer exact_image(const scene::Scene& scene, const scene::Conventions& conventions) {
  const reference::Visibility visibility(
      scene, scene::plan_scene(scene, conventions, scene::Wanted::kNearest));
  const scene::Camera& camera = *scene.camera;
  std::vector<std::int32_t> spheres(static_cast<std::size_t>(camera.width * camera.height));
  visibility.nearest(0, camera.height, {spheres, {}, {}, {}, {}});
  ImageAnswer image(spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (spheres[k] != reference::kNoSphere) image[k] = static_cast<std::size_t>(spheres[k]);
  }
  return image;
}

std::optional<ShownPicture> shown_picture(scene::Scene scene, const Candidate& candidate) {
  ShownPicture shown = {std::move(scene), {}};
  const scene::Camera& camera = *shown.scene.camera;
  shown.scene.conventions = candidate.declared.over(shown.scene.conventions);
  try {
    shown.image = candidate.image(shown.scene, shown.scene.conventions);
  } catch (const OtherSize& other) {
    shown.sides_exchanged = other.width == camera.height && other.height == camera.width;
    if (!shown.sides_exchanged) return {};
  } catch (const std::runtime_error&) {
    return {};
  }
  return shown;
}

}  // namespace raycheck::properties
