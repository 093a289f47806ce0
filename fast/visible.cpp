#include "fast/visible.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace raycheck::fast {
namespace {

using scene::PixelRectangle;

PixelRectangle overlap(const PixelRectangle& a, const PixelRectangle& b) {
  return {std::max(a.i_begin, b.i_begin), std::min(a.i_end, b.i_end),
          std::max(a.j_begin, b.j_begin), std::min(a.j_end, b.j_end)};
}

/// The spheres that some pixel of the rectangle may see.
std::vector<std::size_t> spheres_in(const PixelRectangle& pixels, const scene::ScenePlan& plan,
                                    const std::vector<std::size_t>& among) {
  std::vector<std::size_t> result;
  std::copy_if(among.begin(), among.end(), std::back_inserter(result), [&](std::size_t k) {
    const scene::SpherePlan& sphere = plan.spheres[k];
    return !sphere.left_out && !overlap(sphere.pixels, pixels).empty();
  });
  return result;
}

bool is_finite(const Vectors& vectors, std::size_t k) {
  return std::isfinite(vectors.x[k]) && std::isfinite(vectors.y[k]) && std::isfinite(vectors.z[k]);
}

bool is_ray(const Rays& rays, std::size_t k) {
  const Vectors& direction = rays.direction;
  return is_finite(rays.origin, k) && is_finite(direction, k) &&
         (direction.x[k] != 0 || direction.y[k] != 0 || direction.z[k] != 0);
}

/// Moves the valid rays to the front, and the slots of their answers with them.
void keep_rays(Rays& rays, std::vector<std::size_t>& slots) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (!is_ray(rays, k)) continue;
    for (Vectors* vectors : {&rays.origin, &rays.direction}) {
      vectors->x[kept] = vectors->x[k];
      vectors->y[kept] = vectors->y[k];
      vectors->z[kept] = vectors->z[k];
    }
    slots[kept++] = slots[k];
  }
  rays.resize(kept);
  slots.resize(kept);
}

class Renderer {
 public:
  Renderer(const scene::Scene& scene, const scene::ScenePlan& plan, const PixelRayMethod& rays,
           const IntersectMethod& intersect, const PixelRectangle& pixels, SeenPixels& seen)
      : scene_(scene),
        conventions_(plan.conventions),
        make_rays_(conventions_.origin == scene::Origin::kPixel ? rays.pixel_rays
                                                                : rays.focal_rays),
        intersect_(intersect),
        pixels_(pixels),
        seen_(seen) {}

  void see(const PixelRectangle& tile, const std::vector<std::size_t>& spheres) {
    asked_.clear();
    slots_.clear();
    for (std::int64_t j = tile.j_begin; j < tile.j_end; ++j) {
      for (std::int64_t i = tile.i_begin; i < tile.i_end; ++i) {
        asked_.push_back({i, j});
        slots_.push_back(slot(i, j));
      }
    }
    make_rays_(*scene_.camera, conventions_, asked_, rays_);
    keep_rays(rays_, slots_);
    for (const std::size_t sphere : spheres) see(sphere);
  }

 private:
  std::size_t slot(std::int64_t i, std::int64_t j) const {
    return static_cast<std::size_t>((j - pixels_.j_begin) * (pixels_.i_end - pixels_.i_begin) +
                                    (i - pixels_.i_begin));
  }

  void see(std::size_t sphere) {
    intersect_.intersect(rays_, scene_.spheres[sphere], conventions_.root, conventions_.tangent,
                         hits_);
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      std::int32_t& nearest = seen_.sphere[slots_[k]];
      double& parameter = seen_.parameter[slots_[k]];
      if (!hits_.hit[k] || (nearest != kNothingSeen && parameter <= hits_.parameter[k])) continue;
      nearest = static_cast<std::int32_t>(sphere);
      parameter = hits_.parameter[k];
    }
  }

  const scene::Scene& scene_;
  const scene::Conventions& conventions_;
  PixelRayMethod::MakeRays make_rays_;
  const IntersectMethod& intersect_;
  PixelRectangle pixels_;
  SeenPixels& seen_;
  // For the current tile.
  std::vector<scene::Pixel> asked_;
  std::vector<std::size_t> slots_;
  Rays rays_;
  Hits hits_;
};

}  // namespace

void see(const scene::Scene& scene, const scene::ScenePlan& plan, const PixelRayMethod& rays,
         const IntersectMethod& intersect, const PixelRectangle& pixels, SeenPixels& seen) {
  seen.resize(static_cast<std::size_t>(pixels.count()));
  std::vector<std::size_t> all(plan.spheres.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Renderer renderer(scene, plan, rays, intersect, pixels, seen);
  for (std::int64_t j = pixels.j_begin; j < pixels.j_end; j += kVisibleTile) {
    const PixelRectangle band =
        overlap(pixels, {pixels.i_begin, pixels.i_end, j, j + kVisibleTile});
    const std::vector<std::size_t> in_band = spheres_in(band, plan, all);
    for (std::int64_t i = pixels.i_begin; i < pixels.i_end; i += kVisibleTile) {
      const PixelRectangle tile = overlap(band, {i, i + kVisibleTile, j, j + kVisibleTile});
      const std::vector<std::size_t> in_tile = spheres_in(tile, plan, in_band);
      if (!in_tile.empty()) renderer.see(tile, in_tile);
    }
  }
}

}  // namespace raycheck::fast
