#include "fast/internal/eigen.h"
#include "fast/internal/pixel_plane.h"
#include "fast/pixel_ray.h"

namespace raycheck::fast {
namespace {

using Eigen::Vector3f;

template <class Triple>
Vector3f single(const Triple& value) {
  return eigen(value).template cast<float>();
}

/// The axes, alpha and beta, all in floats.
class SinglePlane {
 public:
  SinglePlane(const scene::Camera& camera, const scene::Conventions& conventions)
      : camera_(camera), conventions_(conventions), E_(single(camera.eye)) {
    require_valid(camera, conventions);
    const Vector3f to_eye = E_ - single(camera.look_at);
    const Vector3f W = to_eye / to_eye.norm();
    const Vector3f across = single(camera.up).cross(W);
    U_ = across / across.norm();
    V_ = W.cross(U_);
    to_plane_ = static_cast<float>(camera.near) * W;
  }

  const Vector3f& E() const { return E_; }

  Vector3f to_pixel(const scene::Pixel& pixel) const {
    const bool bottom_first = conventions_.rows == scene::Rows::kBottomFirst;
    const float alpha = coordinate(pixel.i, camera_.width, camera_.left, camera_.right);
    const float beta = bottom_first
                           ? coordinate(pixel.j, camera_.height, camera_.bottom, camera_.top)
                           : coordinate(pixel.j, camera_.height, camera_.top, camera_.bottom);
    return to_plane_ + alpha * U_ + beta * V_;
  }

 private:
  float coordinate(std::int64_t index, std::int64_t count, double from, double to) const {
    const auto first = static_cast<float>(from);
    const auto last = static_cast<float>(to);
    const float position = conventions_.samples == scene::Samples::kEdges
                               ? static_cast<float>(index) / static_cast<float>(count - 1)
                               : (static_cast<float>(index) + 0.5F) / static_cast<float>(count);
    return first + position * (last - first);
  }

  const scene::Camera& camera_;
  const scene::Conventions& conventions_;
  Vector3f E_, U_, V_, to_plane_;
};

void pixel_points(const scene::Camera& camera, const scene::Conventions& conventions,
                  std::span<const scene::Pixel> pixels, Vectors& points) {
  const SinglePlane plane(camera, conventions);
  points.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const Vector3f point = plane.E() + plane.to_pixel(pixels[k]);
    store(points, k, point.cast<double>());
  }
}

/// A ray from the eye starts at the eye as given, which needs no arithmetic.
template <scene::Origin kOrigin>
void make_rays(const scene::Camera& camera, const scene::Conventions& conventions,
               std::span<const scene::Pixel> pixels, Rays& rays) {
  const SinglePlane plane(camera, conventions);
  rays.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const Vector3f g = plane.to_pixel(pixels[k]);
    const Vector3f direction = g / g.norm();
    const Vector3f point = plane.E() + g;
    store(rays.origin, k,
          kOrigin == scene::Origin::kPixel ? Eigen::Vector3d(point.cast<double>())
                                           : eigen(camera.eye));
    store(rays.direction, k, direction.cast<double>());
  }
}

}  // namespace

/// `direct` in single precision, axes included; lengths are in kSingleDomain.
const PixelRayMethod kSingleRays = {
    .name = "single",
    .sentence = "direct, everything in single precision",
    .pixel_points = pixel_points,
    .pixel_rays = make_rays<scene::Origin::kPixel>,
    .focal_rays = make_rays<scene::Origin::kFocal>,
    .max_point_ulp = 56 * 0x1p29,
    .max_direction_ulp = 256 * 0x1p29,
    .max_unit_defect_ulp = 4 * 0x1p29,
    .not_kept = "eyes far from the origin",
    .domain = kSingleDomain,
    .unit_roundoff = 0x1p-24,
};

}  // namespace raycheck::fast
