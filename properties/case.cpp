#include "properties/case.h"

#include <cstdint>

namespace raycheck::properties {

std::size_t count_rays(const Case& the_case) {
  return the_case.scene.camera ? the_case.pixels.size() : the_case.scene.rays.size();
}

std::vector<scene::Pixel> all_pixels(const scene::Camera& camera) {
  std::vector<scene::Pixel> pixels;
  pixels.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (std::int64_t j = 0; j < camera.height; ++j) {
    for (std::int64_t i = 0; i < camera.width; ++i) pixels.push_back({i, j});
  }
  return pixels;
}

}  // namespace raycheck::properties
