#include "fast/pixel_plane.h"
#include "fast/pixel_ray.h"

namespace raycheck::fast {
namespace {

Eigen::Vector3d eye_to_pixel(const PixelPlane& plane, const scene::Pixel& pixel) {
  return plane.camera.near * plane.W + plane.alpha(pixel) * plane.U + plane.beta(pixel) * plane.V;
}

void pixel_points(const scene::Camera& camera, const scene::Conventions& conventions,
                  std::span<const scene::Pixel> pixels, Vectors& points) {
  const PixelPlane plane(camera, conventions);
  points.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    store(points, k, plane.E + eye_to_pixel(plane, pixels[k]));
  }
}

template <scene::Origin kOrigin>
void rays(const scene::Camera& camera, const scene::Conventions& conventions,
          std::span<const scene::Pixel> pixels, Rays& out) {
  const PixelPlane plane(camera, conventions);
  out.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const Eigen::Vector3d g = eye_to_pixel(plane, pixels[k]);
    store(out.origin, k, kOrigin == scene::Origin::kPixel ? Eigen::Vector3d(plane.E + g) : plane.E);
    store(out.direction, k, g / g.norm());
  }
}

}  // namespace

const PixelRayMethod kDirectRays = {"direct",
                                    "D from g = nW + alpha U + beta V, P = E + g",
                                    pixel_points,
                                    rays<scene::Origin::kPixel>,
                                    rays<scene::Origin::kFocal>,
                                    kPixelPointMaxUlp,
                                    kDirectDirectionMaxUlp,
                                    kUnitDefectMaxUlp,
                                    ""};

}  // namespace raycheck::fast
