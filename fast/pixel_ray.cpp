#include "fast/pixel_ray.h"

#include "fast/internal/pixel_plane.h"

namespace raycheck::fast {
namespace {

constexpr const PixelRayMethod* kRayMethods[] = {
#define RAYCHECK_ADDRESS(name) &k##name##Rays,
    RAYCHECK_PIXEL_RAY_METHODS(RAYCHECK_ADDRESS)
#undef RAYCHECK_ADDRESS
};

}  // namespace

std::span<const PixelRayMethod* const> pixel_ray_methods() { return kRayMethods; }

PlanePosition plane_position(const scene::Camera& camera, const scene::Conventions& conventions,
                             const scene::Pixel& pixel) {
  const PixelPlane plane(camera, conventions);
  return {plane.alpha(pixel), plane.beta(pixel)};
}

}  // namespace raycheck::fast
