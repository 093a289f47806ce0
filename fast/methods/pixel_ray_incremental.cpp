#include "fast/internal/pixel_plane.h"
#include "fast/pixel_ray.h"

namespace raycheck::fast {
namespace {

/// How many pixels of a row are stepped over before it restarts by multiplication, as a tiled
/// renderer does. A pixel's answer then depends on its column alone, not on which pixels are asked
/// for; a batch in row order costs one addition per pixel.
constexpr std::int64_t kIncrementalTile = 64;

/// E to P for successive pixels: adds du along a row, restarting at each tile's first column.
class Steps {
 public:
  explicit Steps(const PixelPlane& plane) : plane_(plane) {
    const scene::Camera& camera = plane.camera;
    const bool edges = plane.conventions.samples == scene::Samples::kEdges;
    const auto steps = static_cast<double>(edges ? camera.width - 1 : camera.width);
    step_ = ((camera.right - camera.left) / steps) * plane.U;
  }

  const Eigen::Vector3d& at(const scene::Pixel& pixel) {
    const std::int64_t first = pixel.i - pixel.i % kIncrementalTile;
    const bool is_next = pixel.j == now_.j && pixel.i == now_.i + 1 && pixel.i != first;
    if (!is_next) {
      const scene::Pixel start = {first, pixel.j};
      to_pixel_ = plane_.camera.near * plane_.W + plane_.alpha(start) * plane_.U +
                  plane_.beta(start) * plane_.V;
      now_.i = first;
    }
    for (; now_.i < pixel.i; ++now_.i) to_pixel_ += step_;
    now_.j = pixel.j;
    return to_pixel_;
  }

 private:
  const PixelPlane& plane_;
  Eigen::Vector3d step_;
  Eigen::Vector3d to_pixel_ = Eigen::Vector3d::Zero();
  scene::Pixel now_{-2, -1};  // next to no pixel
};

void pixel_points(const scene::Camera& camera, const scene::Conventions& conventions,
                  std::span<const scene::Pixel> pixels, Vectors& points) {
  const PixelPlane plane(camera, conventions);
  Steps steps(plane);
  points.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) store(points, k, plane.E + steps.at(pixels[k]));
}

template <scene::Origin kOrigin>
void make_rays(const scene::Camera& camera, const scene::Conventions& conventions,
               std::span<const scene::Pixel> pixels, Rays& rays) {
  const PixelPlane plane(camera, conventions);
  Steps steps(plane);
  rays.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const Eigen::Vector3d& g = steps.at(pixels[k]);
    store(rays.origin, k, kOrigin == scene::Origin::kPixel ? plane.E + g : plane.E);
    store(rays.direction, k, g / g.norm());
  }
}

}  // namespace

/// `direct` with g stepped along a row by du = (right - left)/(w-1) U, at most kIncrementalTile
/// times, which the bounds allow for.
const PixelRayMethod kIncrementalRays = {
    .name = "incremental",
    .sentence = "g += du along a row, restarted every 64 pixels; D from g, P = E + g",
    .pixel_points = pixel_points,
    .pixel_rays = make_rays<scene::Origin::kPixel>,
    .focal_rays = make_rays<scene::Origin::kFocal>,
    .max_point_ulp = 256,
    .max_direction_ulp = 256,
    .max_unit_defect_ulp = 4,
    .not_kept = "the last column at `right` to the bit, bounds far wider than near",
};

}  // namespace raycheck::fast
