#pragma once

// The pixel loops of a Method: a type that is made from a camera and conventions, and whose trace()
// gives a PixelTrace for a pixel. Internal to fast/.

#include "fast/internal/pixel_plane.h"
#include "fast/pixel_ray.h"

namespace raycheck::fast {

/// A method's results for a pixel: P, and P - E before it is normalised.
template <class Vector>
struct PixelTrace {
  Vector point;
  Vector along;
};

template <class Method>
void pixel_points_batch(const scene::Camera& camera, const scene::Conventions& conventions,
                        std::span<const scene::Pixel> pixels, Vectors& points) {
  Method method(camera, conventions);
  points.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) store(points, k, method.trace(pixels[k]).point);
}

/// Flattened, since a call would pass the trace's vectors through memory.
template <class Method, scene::Origin kOrigin>
[[gnu::flatten]] void rays_batch(const scene::Camera& camera, const scene::Conventions& conventions,
                                 std::span<const scene::Pixel> pixels, Rays& rays) {
  Method method(camera, conventions);
  rays.resize(pixels.size());
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const auto trace = method.trace(pixels[k]);
    if constexpr (kOrigin == scene::Origin::kPixel) {
      store(rays.origin, k, trace.point);
    } else {
      rays.origin.set(k, camera.eye);
    }
    store(rays.direction, k, trace.along / trace.along.norm());
  }
}

}  // namespace raycheck::fast
