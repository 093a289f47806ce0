#include "properties/cases/scene_cases.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raycheck::properties {
namespace {

/// N pixels of an image, spread evenly: the middles of the cells of a grid that is as nearly square
/// as N allows. If N is the number of pixels: all pixels, row by row.
class PixelGrid {
 public:
  PixelGrid(const Camera& camera, std::uint64_t count)
      : width_(static_cast<std::uint64_t>(camera.width)),
        height_(static_cast<std::uint64_t>(camera.height)) {
    const double aspect = static_cast<double>(width_) / static_cast<double>(height_);
    const auto ideal =
        static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(count) * aspect)));
    const std::uint64_t columns = std::clamp<std::uint64_t>(ideal, 1, width_);
    rows_ = std::min(height_, (count + columns - 1) / columns);
    columns_ = (count + rows_ - 1) / rows_;
  }

  Pixel operator[](std::uint64_t index) const {
    const std::uint64_t column = index % columns_;
    const std::uint64_t row = index / columns_;
    return {static_cast<std::int64_t>((2 * column + 1) * width_ / (2 * columns_)),
            static_cast<std::int64_t>((2 * row + 1) * height_ / (2 * rows_))};
  }

 private:
  std::uint64_t width_;
  std::uint64_t height_;
  std::uint64_t columns_;
  std::uint64_t rows_;
};

}  // namespace

SceneCases::SceneCases(Scene scene, std::optional<std::uint64_t> at_most)
    : scene_(std::move(scene)),
      judged_(std::min(rays_in_scene(), at_most.value_or(rays_in_scene()))) {
  if (!scene_.camera) judged_ = rays_in_scene();
}

std::uint64_t SceneCases::rays_in_scene() const {
  if (!scene_.camera) return scene_.rays.size();
  return static_cast<std::uint64_t>(scene_.camera->width) *
         static_cast<std::uint64_t>(scene_.camera->height);
}

Case SceneCases::from(std::uint64_t first, std::uint64_t end) const {
  Case chunk;
  if (scene_.camera) {
    chunk.scene = scene_;
    const PixelGrid grid(*scene_.camera, judged_);
    for (std::uint64_t k = first; k < end; ++k) chunk.pixels.push_back(grid[k]);
  } else {
    chunk.scene.spheres = scene_.spheres;
    chunk.scene.conventions = scene_.conventions;
    chunk.scene.rays.assign(scene_.rays.begin() + static_cast<std::ptrdiff_t>(first),
                            scene_.rays.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return chunk;
}

}  // namespace raycheck::properties
