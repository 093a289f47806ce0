#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "scene/files/scene_file.h"
#include "scene/validate.h"

namespace raycheck::scene {
namespace {

double random_double(std::mt19937_64& random) {
  for (;;) {
    const std::uint64_t pattern = random();
    const double value =
        std::bit_cast<double>(pattern % 16 == 0 ? pattern & ~(0x7ffULL << 52) : pattern);
    if (std::isfinite(value)) return pattern % 17 == 0 ? std::trunc(value) : value;
  }
}

Point3 random_point(std::mt19937_64& random) {
  return {random_double(random), random_double(random), random_double(random)};
}

Vector3 random_vector(std::mt19937_64& random) {
  return {random_double(random), random_double(random), random_double(random)};
}

Scene random_scene(std::mt19937_64& random) {
  Scene scene;
  if (random() % 2 == 0) {
    Camera camera{random_point(random),
                  random_point(random),
                  random_vector(random),
                  random_double(random),
                  {},
                  random_double(random),
                  random_double(random),
                  random_double(random),
                  random_double(random),
                  static_cast<std::int64_t>(2 + random() % (1ULL << (1 + random() % 62))),
                  static_cast<std::int64_t>(2 + random() % 1000)};
    if (random() % 2 == 0) camera.far = random_double(random);
    scene.camera = camera;
  } else {
    for (std::uint64_t i = 0; i <= random() % 3; ++i) {
      scene.rays.push_back({random_point(random), random_vector(random)});
    }
  }
  for (std::uint64_t i = random() % 3; i > 0; --i) {
    scene.spheres.push_back({random_point(random), std::abs(random_double(random))});
  }
  scene.conventions = {static_cast<Rows>(random() % 2), static_cast<Samples>(random() % 2),
                       static_cast<Origin>(random() % 2), static_cast<Root>(random() % 2),
                       static_cast<Tangent>(random() % 3)};
  return scene;
}

TEST(WriteToml, ReadsBackBitIdentically) {
  constexpr int kScenes = 10000;
  std::mt19937_64 random(3);
  int compared = 0, subnormal = 0;
  while (compared < kScenes) {
    const Scene scene = random_scene(random);
    if (!defects(scene).empty()) continue;
    const std::string text = write_toml(scene, "scene\n[camera] = \"1");
    const Scene again = read_toml(text, "again").scene;
    ASSERT_EQ(again, scene) << text;
    // Each double has a spelling of its own, -0 too.
    ASSERT_EQ(write_toml(again), write_toml(scene));
    subnormal += text.find("e-31") != std::string::npos ? 1 : 0;
    ++compared;
  }
  EXPECT_GT(subnormal, 500);
}

TEST(WriteToml, IsReadable) {
  Scene scene;
  scene.rays = {{{-0.0, 1e300, 5e-324}, {1, 0.1, 1e18}}};
  scene.spheres = {{{1, -2, 3}, 1234567890123456768.0}};
  scene.conventions.tangent = Tangent::kMiss;
  EXPECT_EQ(write_toml(scene, "one\n\ntwo\r"),
            "# one\n#\n# two \n\n[conventions]\ntangent = \"miss\"\n\n"
            "[[sphere]]\ncentre = [1, -2, 3]\nradius = 1234567890123456768.0\n\n"
            "[[ray]]\norigin = [-0.0, 1e+300, 5e-324]\ndirection = [1, 0.1, 1e+18]\n");
  scene.conventions = {};
  EXPECT_EQ(write_toml(scene).find("conventions"), std::string::npos);
}

}  // namespace
}  // namespace raycheck::scene
