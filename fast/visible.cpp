#include "fast/visible.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace raycheck::fast {
namespace {

using scene::PixelRectangle;

bool overlap(const PixelRectangle& a, const PixelRectangle& b) {
  return std::max(a.i_begin, b.i_begin) < std::min(a.i_end, b.i_end) &&
         std::max(a.j_begin, b.j_begin) < std::min(a.j_end, b.j_end);
}

template <class Triple>
bool is_finite(const Triple& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_ray(const scene::Ray& ray) {
  return is_finite(ray.origin) && is_finite(ray.direction) && ray.direction != scene::Vector3{};
}

}  // namespace

std::vector<std::optional<FirstHit>> see(const scene::Scene& scene, const scene::ScenePlan& plan,
                                         const PixelRayMethod& rays,
                                         const IntersectMethod& intersect,
                                         const PixelRectangle& pixels) {
  std::vector<scene::Pixel> asked;
  asked.reserve(static_cast<std::size_t>(pixels.count()));
  for (std::int64_t j = pixels.j_begin; j < pixels.j_end; ++j) {
    for (std::int64_t i = pixels.i_begin; i < pixels.i_end; ++i) asked.push_back({i, j});
  }
  std::vector<std::size_t> in_view;
  std::vector<scene::Sphere> spheres;
  for (std::size_t k = 0; k < plan.spheres.size(); ++k) {
    const scene::SpherePlan& sphere = plan.spheres[k];
    if (sphere.left_out || !overlap(sphere.pixels, pixels)) continue;
    in_view.push_back(k);
    spheres.push_back(scene.spheres[k]);
  }
  std::vector<std::optional<FirstHit>> seen(asked.size());
  if (spheres.empty()) return seen;
  const scene::Conventions& conventions = plan.conventions;
  Rays made;
  (conventions.origin == scene::Origin::kPixel ? rays.pixel_rays : rays.focal_rays)(
      *scene.camera, conventions, asked, made);
  // Moves the valid rays to the front; slots[k] is the pixel of ray k.
  std::vector<std::size_t> slots;
  slots.reserve(made.size());
  for (std::size_t k = 0; k < made.size(); ++k) {
    const scene::Ray ray = made.at(k);
    if (!is_ray(ray)) continue;
    made.set(slots.size(), ray);
    slots.push_back(k);
  }
  made.resize(slots.size());
  const auto nearest = nearest_spheres(intersect, made, spheres, conventions.hit_rule());
  for (std::size_t k = 0; k < slots.size(); ++k) {
    if (nearest[k]) seen[slots[k]] = {in_view[nearest[k]->sphere], nearest[k]->parameter};
  }
  return seen;
}

}  // namespace raycheck::fast
