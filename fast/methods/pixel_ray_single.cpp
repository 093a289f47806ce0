#include "fast/internal/pixel_ray_batch.h"

namespace raycheck::fast {
namespace {

using Eigen::Vector3f;

template <class Triple>
Vector3f single(const Triple& value) {
  return eigen(value).template cast<float>();
}

class Single {
 public:
  Single(const scene::Camera& camera, const scene::Conventions& conventions)
      : camera_(camera),
        conventions_(conventions),
        across_(scene::pixel_steps(conventions.samples, camera.width)),
        down_(scene::pixel_steps(conventions.samples, camera.height)),
        E_(single(camera.eye)) {
    scene::require_valid(camera, conventions);
    const Vector3f to_eye = E_ - single(camera.look_at);
    const Vector3f W = to_eye / to_eye.norm();
    const Vector3f across = single(camera.up).cross(W);
    U_ = across / across.norm();
    V_ = W.cross(U_);
    to_plane_ = static_cast<float>(camera.near) * W;
  }

  PixelTrace<Vector3f> trace(const scene::Pixel& pixel) const {
    const bool bottom_first = conventions_.rows == scene::Rows::kBottomFirst;
    const float alpha = coordinate(pixel.i, across_, camera_.left, camera_.right);
    const float beta = bottom_first ? coordinate(pixel.j, down_, camera_.bottom, camera_.top)
                                    : coordinate(pixel.j, down_, camera_.top, camera_.bottom);
    PixelTrace<Vector3f> trace;
    trace.along = to_plane_ + alpha * U_ + beta * V_;
    trace.point = E_ + trace.along;
    return trace;
  }

 private:
  static float coordinate(std::int64_t index, const scene::PixelSteps& along, double from,
                          double to) {
    const auto first = static_cast<float>(from);
    const auto last = static_cast<float>(to);
    const float position = (static_cast<float>(index) + static_cast<float>(along.offset)) /
                           static_cast<float>(along.steps);
    return first + position * (last - first);
  }

  const scene::Camera& camera_;
  const scene::Conventions& conventions_;
  scene::PixelSteps across_, down_;
  Vector3f E_, U_, V_, to_plane_;
};

}  // namespace

/// `direct` in single precision, also for the axes. Domain: kSingleDomain.
const PixelRayMethod kSingleRays = {
    .name = "single",
    .sentence = "direct, everything in single precision",
    .pixel_points = pixel_points_batch<Single>,
    .pixel_rays = rays_batch<Single, scene::Origin::kPixel>,
    .focal_rays = rays_batch<Single, scene::Origin::kFocal>,
    .max_point_ulp = 56 * 0x1p29,
    .max_direction_ulp = 256 * 0x1p29,
    .max_unit_defect_ulp = 4 * 0x1p29,
    .not_kept = "eyes far from the origin",
    .domain = kSingleDomain,
    .unit_roundoff = 0x1p-24,
};

}  // namespace raycheck::fast
