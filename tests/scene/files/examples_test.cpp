#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/files/scene_file.h"
#include "scene/plan/plan.h"

namespace raycheck::scene {
namespace {

std::filesystem::path folder() {
  return std::filesystem::path(RAYCHECK_SOURCE_DIR) / "scene" / "examples";
}

TEST(Examples, EveryOneLoadsAndSaysWhatItShows) {
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    SCOPED_TRACE(entry.path().string());
    std::string first_line;
    std::ifstream file(entry.path());
    ASSERT_TRUE(std::getline(file, first_line));
    EXPECT_EQ(first_line.substr(0, 2), "# ");
    EXPECT_GT(first_line.size(), 30u);
    const LoadedScene loaded = load_scene(entry.path());
    EXPECT_FALSE(loaded.scene.spheres.empty());
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_EQ(loaded.not_needed.empty(), entry.path().extension() == ".toml");
    EXPECT_EQ(read_toml(write_toml(loaded.scene), "again").scene, loaded.scene);
    ++scenes;
  }
  EXPECT_EQ(scenes, 22u);
}

TEST(Examples, ShowSomethingInEveryImage) {
  std::size_t images = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    const Scene scene = load_scene(entry.path()).scene;
    if (!scene.camera || entry.path().stem() == "sphere-behind-eye") continue;
    // From the eye on, so that what is before the image plane counts.
    Conventions conventions = scene.conventions;
    conventions.origin = Origin::kFocal;
    const ScenePlan plan = plan_scene(scene, conventions, Wanted::kNearest);
    EXPECT_TRUE(std::any_of(plan.spheres.begin(), plan.spheres.end(), [](const SpherePlan& sphere) {
      return !sphere.pixels.empty();
    })) << entry.path();
    ++images;
  }
  EXPECT_EQ(images, 19u);
}

}  // namespace
}  // namespace raycheck::scene
