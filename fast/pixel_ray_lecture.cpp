#include "fast/pixel_ray_batch.h"

namespace raycheck::fast {
namespace {

struct Lecture {
  static PixelTrace trace(const PixelPlane& plane, const scene::Pixel& pixel) {
    const Eigen::Vector3d P = plane.E + plane.camera.near * plane.W + plane.alpha(pixel) * plane.U +
                              plane.beta(pixel) * plane.V;
    return {P, P - plane.E};
  }
};

}  // namespace

const PixelRayMethod kLectureRays = {"lecture",
                                     "P = E + nW + alpha U + beta V, then D = (P - E)/|P - E|",
                                     pixel_points_batch<Lecture>,
                                     rays_batch<Lecture, scene::Origin::kPixel>,
                                     rays_batch<Lecture, scene::Origin::kFocal>,
                                     kPixelPointMaxUlp,
                                     kLectureDirectionMaxUlp,
                                     kUnitDefectMaxUlp,
                                     "directions where |E| is much larger than |P - E|"};

}  // namespace raycheck::fast
