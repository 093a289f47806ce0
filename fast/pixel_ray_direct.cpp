#include "fast/pixel_ray_batch.h"

namespace raycheck::fast {
namespace {

struct Direct {
  static PixelTrace trace(const PixelPlane& plane, const scene::Pixel& pixel) {
    const Eigen::Vector3d g =
        plane.camera.near * plane.W + plane.alpha(pixel) * plane.U + plane.beta(pixel) * plane.V;
    return {plane.E + g, g};
  }
};

}  // namespace

const PixelRayMethod kDirectRays = {"direct",
                                    "D from g = nW + alpha U + beta V, P = E + g",
                                    pixel_points_batch<Direct>,
                                    rays_batch<Direct, scene::Origin::kPixel>,
                                    rays_batch<Direct, scene::Origin::kFocal>,
                                    kPixelPointMaxUlp,
                                    kDirectDirectionMaxUlp,
                                    kUnitDefectMaxUlp,
                                    ""};

}  // namespace raycheck::fast
