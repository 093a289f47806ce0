#include "fast/internal/pixel_ray_batch.h"

namespace raycheck::fast {
namespace {

/// The number of steps along a row before g is computed by multiplication again, as in a tiled
/// renderer. So the answer for a pixel does not depend on which pixels are requested. A batch in
/// row order costs one addition per pixel.
constexpr std::int64_t kIncrementalTile = 64;

/// P - E for successive pixels: adds du along a row, and restarts at the first column of each tile.
class Incremental : PixelPlane {
 public:
  Incremental(const scene::Camera& its_camera, const scene::Conventions& its_conventions)
      : PixelPlane(its_camera, its_conventions) {
    step_ = ((camera.right - camera.left) / across.steps) * U;
  }

  PixelTrace<Eigen::Vector3d> trace(const scene::Pixel& pixel) {
    const std::int64_t first = pixel.i - pixel.i % kIncrementalTile;
    const bool is_next = pixel.j == now_.j && pixel.i == now_.i + 1 && pixel.i != first;
    if (!is_next) {
      const scene::Pixel start = {first, pixel.j};
      to_pixel_ = camera.near * W + alpha(start) * U + beta(start) * V;
      now_.i = first;
    }
    for (; now_.i < pixel.i; ++now_.i) to_pixel_ += step_;
    now_.j = pixel.j;
    return {E + to_pixel_, to_pixel_};
  }

 private:
  Eigen::Vector3d step_;
  Eigen::Vector3d to_pixel_ = Eigen::Vector3d::Zero();
  scene::Pixel now_{-2, -1};  // not adjacent to a pixel
};

}  // namespace

/// `direct`, but g is increased by du, a step of (right - left)/steps U, along a row, at most
/// kIncrementalTile times. The bounds allow for these steps.
const PixelRayMethod kIncrementalRays = {
    .name = "incremental",
    .sentence = "g += du along a row, restarted every 64 pixels; D from g, P = E + g",
    .pixel_points = pixel_points_batch<Incremental>,
    .pixel_rays = rays_batch<Incremental, scene::Origin::kPixel>,
    .focal_rays = rays_batch<Incremental, scene::Origin::kFocal>,
    .max_point_ulp = 256,
    .max_direction_ulp = 256,
    .max_unit_defect_ulp = 4,
    .not_kept = "the last column; images whose left, right, bottom or top is much larger than near",
};

}  // namespace raycheck::fast
