#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "scene/camera.h"
#include "scene/geometry.h"
#include "scene/scene.h"

// The inputs of the benchmarks and of the instruction counts; the same in every run.

namespace raycheck::tools {

/// A sphere that covers about a tenth of camera_of()'s image.
inline constexpr scene::Sphere kBenchSphere = {{0.1, 0.3, 0.2}, 2.5};

/// A scene with only the camera.
scene::Scene camera_of(std::int64_t width, std::int64_t height);
/// The camera, 64 x 64 pixels, and kBenchSphere.
scene::Scene scene_in_view();
/// Spheres of radius 0.2 to 1, 5 to 60 from the eye, centres in view.
scene::Scene in_view(std::int64_t spheres, std::int64_t size = 1024);
/// Scenes in which doubles are not enough, or make no difference, and one without that to compare
/// with; 2^20 pixels each.
struct HardScene {
  std::string name;
  scene::Scene scene;
};
std::vector<HardScene> hard_scenes();
/// Practically unrelated rays from anywhere, aimed near a sphere so that a third miss it.
scene::Scene unrelated_rays();
/// The given rays of a scene.
fast::Rays rays_of(const scene::Scene& scene);

/// Pixels all over an image, in an order that defeats branch prediction.
std::vector<scene::Pixel> scattered_pixels(std::int64_t side);

/// A given ray that hits, and an answer that is off by a few ulps.
struct GivenCase {
  scene::Ray ray;
  scene::Sphere sphere;
  double answer;
};
std::vector<GivenCase> hitting_cases();

/// Why the pair must be neither timed nor counted; empty when its answers are right.
std::string wrong_answers(const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect,
                          const scene::Scene& scene);

/// Takes --target=NAME (AVX2, SSE4, EMU128 and so on) out of a benchmark's arguments: Highway then
/// runs that target, or else `otherwise`, and no better. False, after a message, if this machine
/// does not have the target.
bool choose_target(int& argc, char** argv, std::string_view otherwise = "");

}  // namespace raycheck::tools
