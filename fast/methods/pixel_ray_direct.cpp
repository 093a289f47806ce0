#include "fast/internal/pixel_ray_batch.h"

namespace raycheck::fast {
namespace {

struct Direct : PixelPlane {
  using PixelPlane::PixelPlane;

  PixelTrace<Eigen::Vector3d> trace(const scene::Pixel& pixel) const {
    // Computed in place: a copy of g would be stored by coordinates and loaded in pairs, which
    // stalls.
    PixelTrace<Eigen::Vector3d> trace;
    trace.along = camera.near * W + alpha(pixel) * U + beta(pixel) * V;
    trace.point = E + trace.along;
    return trace;
  }
};

}  // namespace

/// D from g = n W + alpha U + beta V, so that |E| does not affect it; P = E + g.
const PixelRayMethod kDirectRays = {
    .name = "direct",
    .sentence = "D from g = nW + alpha U + beta V, P = E + g",
    .pixel_points = pixel_points_batch<Direct>,
    .pixel_rays = rays_batch<Direct, scene::Origin::kPixel>,
    .focal_rays = rays_batch<Direct, scene::Origin::kFocal>,
    .max_point_ulp = 128,
    .max_direction_ulp = 64,
    .max_unit_defect_ulp = 4,
};

}  // namespace raycheck::fast
