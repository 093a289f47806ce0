#include "fast/internal/pixel_ray_batch.h"

namespace raycheck::fast {
namespace {

struct Direct {
  static PixelTrace trace(const PixelPlane& plane, const scene::Pixel& pixel) {
    // In place: a copy of g would be stored by coordinates and loaded in pairs, which stalls.
    PixelTrace trace;
    trace.along =
        plane.camera.near * plane.W + plane.alpha(pixel) * plane.U + plane.beta(pixel) * plane.V;
    trace.point = plane.E + trace.along;
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
