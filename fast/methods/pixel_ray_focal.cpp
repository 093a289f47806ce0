#include "fast/internal/pixel_plane.h"
#include "fast/pixel_ray.h"

namespace raycheck::fast {
namespace {

void focal_rays(const scene::Camera& camera, const scene::Conventions& conventions,
                std::span<const scene::Pixel> pixels, Rays& out) {
  const PixelPlane plane(camera, conventions);
  const Eigen::Vector3d to_plane = camera.near * plane.W;
  out.resize(pixels.size());
  out.origin.x.assign(pixels.size(), camera.eye.x);
  out.origin.y.assign(pixels.size(), camera.eye.y);
  out.origin.z.assign(pixels.size(), camera.eye.z);
  const double near_sq = camera.near * camera.near;
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const double alpha = plane.alpha(pixels[k]);
    const double beta = plane.beta(pixels[k]);
    // The axes are orthonormal, so that the length does not depend on them.
    const double length = std::sqrt(near_sq + alpha * alpha + beta * beta);
    store(out.direction, k, (to_plane + alpha * plane.U + beta * plane.V) / length);
  }
}

}  // namespace

/// Rays from E only; terms that all pixels share are computed once. It assumes orthonormal axes;
/// its bound on |D| allows for their defects.
const PixelRayMethod kFocalRays = {
    .name = "focal",
    .sentence = "rays from E; nW and n^2 once per scene, |g| from n, alpha, beta",
    .pixel_points = nullptr,
    .pixel_rays = nullptr,
    .focal_rays = focal_rays,
    .max_point_ulp = 128,
    .max_direction_ulp = 64,
    .max_unit_defect_ulp = 8,
};

}  // namespace raycheck::fast
