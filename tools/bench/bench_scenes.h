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

/// A sphere that covers about a tenth of the image of camera_of().
inline constexpr scene::Sphere kBenchSphere = {{0.1, 0.3, 0.2}, 2.5};

/// A scene with only the camera.
scene::Scene camera_of(std::int64_t width, std::int64_t height);
/// The camera, 64 x 64 pixels, and kBenchSphere.
scene::Scene scene_in_view();
/// Spheres of radius 0.2 to 1, at distances 5 to 60 from the eye, with their centres in view.
scene::Scene in_view(std::int64_t spheres, std::int64_t size = 1024);
/// Scenes of 2^20 pixels: some in which doubles are often not enough to decide, others in which
/// that makes no difference, and an easy one for comparison.
struct HardScene {
  std::string name;
  scene::Scene scene;
};
std::vector<HardScene> hard_scenes();
/// Rays that have practically nothing in common, aimed so near to a sphere that a third of them
/// miss it.
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

/// Removes --target=NAME (AVX2, SSE4, EMU128 and so on) from a benchmark's arguments. Highway then
/// uses at most that target; without the argument, at most `otherwise`. Prints a message and
/// returns false if this machine does not have the target.
bool choose_target(int& argc, char** argv, std::string_view otherwise = "");

}  // namespace raycheck::tools
