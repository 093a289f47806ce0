#include "fast/pixel_plane.h"
#include "fast/pixel_ray.h"

namespace raycheck::fast {
namespace {

Eigen::Vector3d pixel_point(const PixelPlane& plane, const scene::Pixel& pixel) {
  return plane.E + plane.camera.near * plane.W + plane.alpha(pixel) * plane.U +
         plane.beta(pixel) * plane.V;
}

void pixel_points(const scene::Camera& camera, const scene::Conventions& conventions,
                  std::span<const scene::Pixel> pixels, Vectors& points) {
  const PixelPlane plane(camera, conventions);
  points.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) store(points, k, pixel_point(plane, pixels[k]));
}

template <scene::Origin kOrigin>
void rays(const scene::Camera& camera, const scene::Conventions& conventions,
          std::span<const scene::Pixel> pixels, Rays& out) {
  const PixelPlane plane(camera, conventions);
  out.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const Eigen::Vector3d P = pixel_point(plane, pixels[k]);
    const Eigen::Vector3d along = P - plane.E;
    store(out.origin, k, kOrigin == scene::Origin::kPixel ? P : plane.E);
    store(out.direction, k, along / along.norm());
  }
}

}  // namespace

const PixelRayMethod kLectureRays = {"lecture",
                                     "P = E + nW + alpha U + beta V, then D = (P - E)/|P - E|",
                                     pixel_points,
                                     rays<scene::Origin::kPixel>,
                                     rays<scene::Origin::kFocal>,
                                     kPixelPointMaxUlp,
                                     kLectureDirectionMaxUlp,
                                     kUnitDefectMaxUlp,
                                     "directions where |E| is much larger than |P - E|"};

}  // namespace raycheck::fast
