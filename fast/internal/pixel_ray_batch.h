#pragma once

// The pixel loops of the methods that compute each ray independently. Internal to fast/.

#include "fast/internal/pixel_plane.h"
#include "fast/pixel_ray.h"

namespace raycheck::fast {

/// What a method computes for a pixel: P, and P - E before it is normalised.
struct PixelTrace {
  Eigen::Vector3d point;
  Eigen::Vector3d along;
};

template <class Method>
void pixel_points_batch(const scene::Camera& camera, const scene::Conventions& conventions,
                        std::span<const scene::Pixel> pixels, Vectors& points) {
  const PixelPlane plane(camera, conventions);
  points.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    store(points, k, Method::trace(plane, pixels[k]).point);
  }
}

/// Flattened: a call would pass the trace's vectors through memory.
template <class Method, scene::Origin kOrigin>
[[gnu::flatten]] void rays_batch(const scene::Camera& camera, const scene::Conventions& conventions,
                                 std::span<const scene::Pixel> pixels, Rays& rays) {
  const PixelPlane plane(camera, conventions);
  rays.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const PixelTrace trace = Method::trace(plane, pixels[k]);
    if constexpr (kOrigin == scene::Origin::kPixel) {
      store(rays.origin, k, trace.point);
    } else {
      store(rays.origin, k, plane.E);
    }
    store(rays.direction, k, trace.along / trace.along.norm());
  }
}

}  // namespace raycheck::fast
