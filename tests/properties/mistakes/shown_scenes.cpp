#include "tests/properties/mistakes/shown_scenes.h"

#include "scene/files/scene_file.h"

namespace raycheck::properties {
namespace {

using scene::Camera;
using scene::Scene;
using scene::Sphere;

Camera square() {
  Camera camera;
  camera.look_at = {0, 0, -1};
  camera.up = {0, 1, 0};
  camera.near = -1;
  camera.left = camera.bottom = -1;
  camera.right = camera.top = 1;
  camera.width = camera.height = 25;
  return camera;
}

Camera asymmetric() {
  Camera camera = square();
  camera.left = -1.75;
  camera.right = 1.25;
  camera.bottom = -1;
  camera.top = 1.5;
  return camera;
}

Camera oblong() {
  Camera camera = square();
  camera.left = -1.5;
  camera.right = 1.5;
  camera.width = 31;
  camera.height = 21;
  return camera;
}

Camera tilted() {
  Camera camera = square();
  camera.eye = {0.5, 1.25, 6};
  camera.look_at = {-0.75, 0.5, 0};
  camera.up = {0.5, 2, 0.25};
  camera.near = -1.5;
  return camera;
}

Scene scene_of(const Camera& camera, std::vector<Sphere> spheres) {
  Scene scene;
  scene.camera = camera;
  scene.spheres = std::move(spheres);
  return scene;
}

/// Spheres at a billionth of a length from the eye, at ten times as much, and so on: what is
/// compared with a fixed small number loses the first of them.
Scene ladder() {
  Scene scene;
  Camera camera = square();
  camera.near = -1e-10;
  camera.left = camera.bottom = -1e-10;
  camera.right = camera.top = 1e-10;
  scene.camera = camera;
  double way = 4e-10;
  for (int k = 0; k < 10; ++k, way *= 10) {
    const double x = 0.3 * (k % 4) - 0.45;
    const double y = 0.5 * (k / 4) - 0.5;
    scene.spheres.push_back({{x * way, y * way, -way}, 0.15 * way});
  }
  return scene;
}

}  // namespace

const Scene& probe() {
  static const Scene kProbe =
      scene::load_scene(RAYCHECK_SOURCE_DIR "/scene/examples/probe.toml").scene;
  return kProbe;
}

std::vector<Scene> rubric_scenes() {
  Scene with_far_root = scene_of(square(), {{{0, 0, -2}, 4}, {{0.5, 0.25, -4}, 0.75}});
  return {
      scene_of(square(), {{{-5, 4, -10}, 2.25}, {{6, -5, -10}, 1}}),
      scene_of(asymmetric(), {{{-4, 3, -6}, 1.5}, {{2, -2, -5}, 1.25}, {{3, 4, -6}, 0.75}}),
      scene_of(oblong(), {{{1.5, 0.5, -5}, 1.25}}),
      scene_of(oblong(), {{{-2, 1, -6}, 1.5}, {{2.5, -1.5, -7}, 2.25}, {{0.5, 1.25, -4}, 0.5}}),
      scene_of(tilted(), {{{-2, 0, -1}, 1.25}, {{1.5, 2.25, 0}, 1}, {{0.75, -1, 1.5}, 0.5}}),
      scene_of(square(), {{{0, 0, -8}, 2}, {{0.5, 1, -12}, 6}, {{0.25, -0.5, -5}, 0.75}}),
      scene_of(square(), {{{0.25, -0.5, -5}, 0.75}, {{0, 0, -8}, 2}, {{0.5, 1, -12}, 6}}),
      scene_of(square(), {{{0.125, 0.25, -0.75}, 0.375}, {{1, 1.5, -5}, 1}, {{-1, 0, -4}, 0.5}}),
      scene_of(square(), {{{0.5, 0, -5}, 1.25}, {{3, 2, 5}, 1.5}, {{-2, 3, 6}, 1.25}}),
      with_far_root,
      ladder(),
      probe(),
  };
}

std::vector<ShownPicture> shown_with(const Fault& fault, const std::vector<Scene>& scenes) {
  std::vector<ShownPicture> pictures;
  for (const Scene& scene : scenes) pictures.push_back({scene, predicted(fault, scene)});
  return pictures;
}

}  // namespace raycheck::properties
