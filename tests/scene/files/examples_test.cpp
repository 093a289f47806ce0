#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/files/scene_file.h"

namespace raycheck::scene {
namespace {

std::filesystem::path folder() {
  return std::filesystem::path(RAYCHECK_SOURCE_DIR) / "scene" / "examples";
}

LoadedScene example(const std::string& name) { return load_scene(folder() / name); }

Camera wide_view(std::int64_t width, std::int64_t height) {
  return {{8, 8, 90}, {8, 8, 54}, {0, 1, 0}, -20, -65, -8, 8, 4.5, -4.5, width, height};
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

TEST(Examples, OfExample6DifferInTheRowsAlone) {
  Scene bottom_first = example("example-6-bottom-first.toml").scene;
  const Scene top_first = example("example-6-top-first.toml").scene;
  EXPECT_EQ(bottom_first.camera, wide_view(16, 9));
  EXPECT_EQ(bottom_first.conventions, Conventions{});
  bottom_first.conventions.rows = Rows::kTopFirst;
  EXPECT_EQ(bottom_first, top_first);
}

// Every other example camera looks along -z with y up, so that U, V, W are the axes.
std::size_t lines_met(const Scene& scene) {
  const Camera& camera = *scene.camera;
  EXPECT_EQ(camera.look_at.x, camera.eye.x);
  EXPECT_EQ(camera.look_at.y, camera.eye.y);
  EXPECT_EQ(camera.up, (Vector3{0, 1, 0}));
  std::size_t met = 0;
  for (std::int64_t j = 0; j < camera.height; ++j) {
    for (std::int64_t i = 0; i < camera.width; ++i) {
      const double across = static_cast<double>(i) / static_cast<double>(camera.width - 1);
      const double down = static_cast<double>(j) / static_cast<double>(camera.height - 1);
      const Vector3 d = {camera.left + across * (camera.right - camera.left),
                         camera.bottom + down * (camera.top - camera.bottom), camera.near};
      for (const Sphere& sphere : scene.spheres) {
        const Vector3 t = sphere.centre - camera.eye;
        // |t x d|^2 < |d|^2 r^2: the other form cancels on the far sphere.
        const Vector3 moment = {t.y * d.z - t.z * d.y, t.z * d.x - t.x * d.z,
                                t.x * d.y - t.y * d.x};
        const double length_sq = d.x * d.x + d.y * d.y + d.z * d.z;
        const double moment_sq = moment.x * moment.x + moment.y * moment.y + moment.z * moment.z;
        if (moment_sq < length_sq * sphere.radius * sphere.radius) ++met;
      }
    }
  }
  return met;
}

TEST(Examples, ShowSomethingInEveryImage) {
  std::size_t images = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    const Scene scene = load_scene(entry.path()).scene;
    // The camera of `probe` is tilted; what it shows is judged in
    // tests/tools/external/candidate_test.cpp.
    if (!scene.camera || entry.path().stem() == "probe") continue;
    EXPECT_GT(lines_met(scene), 0u) << entry.path();
    ++images;
  }
  EXPECT_EQ(images, 19u);
}

}  // namespace
}  // namespace raycheck::scene
