#include "properties/given_rays.h"

#include <utility>

#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "scene/validate.h"

namespace raycheck::properties {

Place GivenRays::place(Place of_ray) const {
  const scene::Pixel& pixel = pixels.at(of_ray.ray);
  of_ray.ray = static_cast<std::size_t>(pixel.j * width + pixel.i);
  of_ray.pixel = pixel;
  return of_ray;
}

std::optional<GivenRays> given_rays(const Case& the_case, const scene::Conventions& conventions,
                                    scene::Precision precision) {
  const reference::ExactCamera camera(the_case.scene.camera.value(), conventions);
  GivenRays given;
  given.width = the_case.scene.camera->width;
  scene::Scene& scene = given.the_case.scene;
  scene.spheres = the_case.scene.spheres;
  scene.conventions = the_case.scene.conventions;
  for (const scene::Pixel& pixel : the_case.pixels) {
    const reference::ExactRay exact(camera, pixel);
    const auto [x, y, z] = exact.rounded_direction(precision);
    const scene::Ray ray = {exact.rounded_origin(precision), {x, y, z}};
    if (!scene::defects(ray).empty()) continue;
    scene.rays.push_back(ray);
    given.pixels.push_back(pixel);
  }
  return scene.rays.empty() ? std::nullopt : std::optional(std::move(given));
}

}  // namespace raycheck::properties
