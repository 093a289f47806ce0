#include "tests/properties/mistakes/shown_scenes.h"

#include "scene/files/scene_file.h"

namespace raycheck::properties {

using scene::Scene;

namespace {

/// Spheres at a billionth of a length from the eye, at ten times as much, and so on: what is
/// compared with a fixed small number loses the first of them.
Scene ladder(Scene scene) {
  scene::Camera& camera = *scene.camera;
  camera.near = camera.left = camera.bottom = -1e-10;
  camera.right = camera.top = 1e-10;
  scene.spheres.clear();
  double way = 4e-10;
  for (int k = 0; k < 10; ++k, way *= 10) {
    const double x = 0.3 * (k % 4) - 0.45, y = 0.5 * (k / 4) - 0.5;
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

Scene rubric_scene(const std::string& name) {
  return scene::load_scene(RAYCHECK_SOURCE_DIR "/examples/rubrics/lecture7/" + name + ".toml")
      .scene;
}

std::vector<Scene> rubric_scenes() {
  static const std::vector<Scene> kScenes = [] {
    std::vector<Scene> scenes;
    for (const char* name : {"orientation", "corners", "wide", "tall", "tilted", "overlap",
                             "overlap-reversed", "before", "behind", "frame", "edges"}) {
      scenes.push_back(rubric_scene(name));
    }
    scenes.push_back(probe());
    // Around the eye, where the far root counts.
    scenes.push_back(scenes.front());
    scenes.back().spheres = {{{0, 0, -2}, 4}, {{0.5, 0.25, -4}, 0.75}};
    scenes.push_back(ladder(scenes.front()));
    return scenes;
  }();
  return kScenes;
}

std::vector<ShownPicture> shown_with(const Fault& fault, const std::vector<Scene>& scenes) {
  std::vector<ShownPicture> pictures;
  for (const Scene& scene : scenes) pictures.push_back({scene, predicted(fault, scene)});
  return pictures;
}

}  // namespace raycheck::properties
