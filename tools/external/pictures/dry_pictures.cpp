#include "tools/external/pictures/dry_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "properties/cases/case_source.h"

namespace raycheck::tools {
namespace {

/// If this share of the frame has the same colour, it is the background colour.
constexpr double kBackgroundShare = 0.9;

/// A frame with this many colours, each on at most this share of it, is a shaded sky.
constexpr std::size_t kShadedColours = 12;
constexpr double kShadedShare = 0.3;

/// The colours along the border of a picture.
struct Frame {
  std::size_t colours = 0, pixels = 0;
  Colour most;  ///< The most frequent colour.
  std::size_t of_most = 0;

  explicit Frame(const ReadPicture& picture) {
    const auto less = [](const Colour& a, const Colour& b) {
      return std::tie(a.red, a.green, a.blue) < std::tie(b.red, b.green, b.blue);
    };
    std::map<Colour, std::size_t, decltype(less)> counts(less);
    for (std::int64_t y = 0; y < picture.height; ++y) {
      for (std::int64_t x = 0; x < picture.width; ++x) {
        if (x != 0 && y != 0 && x + 1 != picture.width && y + 1 != picture.height) continue;
        ++counts[picture.pixels[static_cast<std::size_t>(y * picture.width + x)]];
        ++pixels;
      }
    }
    for (const auto& [colour, count] : counts) {
      if (count > of_most) most = colour, of_most = count;
    }
    colours = counts.size();
  }
  double share_of_most() const {
    return static_cast<double>(of_most) / static_cast<double>(pixels);
  }
};

}  // namespace

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

Colour background_of(const ReadPicture& picture) {
  const Frame frame(picture);
  if (frame.share_of_most() < kBackgroundShare) return {};
  const bool shows_more =
      std::ranges::any_of(picture.pixels, [&](const Colour& c) { return !(c == frame.most); });
  return shows_more ? frame.most : Colour{};
}

bool is_shaded_around(const ReadPicture& picture) {
  const Frame frame(picture);
  return frame.colours >= kShadedColours && frame.share_of_most() < kShadedShare;
}

double likeness(const ReadPicture& picture, const properties::ImageAnswer& truth) {
  if (picture.pixels.empty()) return 0;
  const Colour background = background_of(picture);
  double both = 0, either = 0;
  for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
    const bool is_shown = !(picture.pixels[k] == background);
    both += is_shown && truth[k] ? 1 : 0;
    either += is_shown || truth[k] ? 1 : 0;
  }
  return either == 0 ? 0 : both / either;
}

}  // namespace raycheck::tools
