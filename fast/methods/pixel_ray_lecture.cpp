#include "fast/internal/pixel_ray_batch.h"

namespace raycheck::fast {
namespace {

struct Lecture : PixelPlane {
  using PixelPlane::PixelPlane;

  PixelTrace<Eigen::Vector3d> trace(const scene::Pixel& pixel) const {
    const Eigen::Vector3d P = E + camera.near * W + alpha(pixel) * U + beta(pixel) * V;
    return {P, P - E};
  }
};

}  // namespace

/// Literally P = E + n W + alpha U + beta V, then D = (P - E)/|P - E|. P - E cancels if |E| is
/// large.
const PixelRayMethod kLectureRays = {
    .name = "lecture",
    .sentence = "P = E + nW + alpha U + beta V, then D = (P - E)/|P - E|",
    .pixel_points = pixel_points_batch<Lecture>,
    .pixel_rays = rays_batch<Lecture, scene::Origin::kPixel>,
    .focal_rays = rays_batch<Lecture, scene::Origin::kFocal>,
    .max_point_ulp = 128,
    .max_direction_ulp = 64,
    .max_unit_defect_ulp = 4,
    .not_kept = "directions where |E| is much larger than |P - E|",
};

}  // namespace raycheck::fast
