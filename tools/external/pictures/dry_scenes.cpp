#include "tools/external/pictures/dry_scenes.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "properties/cases/case_source.h"

namespace raycheck::tools {

scene::Scene symmetric_scene() {
  scene::Scene scene;
  scene::Camera camera;
  camera.eye = {0, 0, 40};
  camera.look_at = {0, 0, 0};
  camera.up = {0, 1, 0};
  camera.near = -1;
  camera.left = camera.bottom = -1;
  camera.right = camera.top = 1;
  camera.width = camera.height = 25;
  scene.camera = camera;
  scene.conventions.rows = scene::Rows::kTopFirst;
  for (const double distance : {10.0, -10.0, 0.5}) {
    for (const auto& [x, y] :
         {std::pair(0.0, 0.0), {0.6, 0.0}, {-0.6, 0.0}, {0.0, 0.6}, {0.0, -0.6}}) {
      scene.spheres.push_back(
          {{distance * x, distance * y, 40 - distance}, 0.2 * std::abs(distance)});
    }
  }
  return scene;
}

scene::Scene whole_scene() {
  constexpr double kScale = 10;
  scene::Scene scene = symmetric_scene();
  scene::Camera& camera = *scene.camera;
  for (double* x :
       {&camera.eye.z, &camera.near, &camera.left, &camera.right, &camera.bottom, &camera.top}) {
    *x *= kScale;
  }
  for (auto& [centre, radius] : scene.spheres) {
    centre = {kScale * centre.x, kScale * centre.y, kScale * centre.z};
    radius *= kScale;
  }
  return scene;
}

std::vector<scene::Scene> ordinary_scenes() {
  constexpr std::uint64_t kCount = 3;
  std::vector<scene::Scene> scenes;
  for (std::uint64_t seed = 1; seed <= kCount; ++seed) {
    scenes.push_back(properties::find_case_source("course-behind")->make(0, seed).scene);
  }
  return scenes;
}

scene::Scene middle_spheres() {
  scene::Scene scene = symmetric_scene();
  const auto& all = scene.spheres;
  scene.spheres = {all[0], all[5], all[10]};
  return scene;
}

}  // namespace raycheck::tools
