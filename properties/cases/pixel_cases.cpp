// Sources of cameras with spheres placed along the rays of given pixels.

#include <algorithm>
#include <cmath>

#include "properties/cases/case_list.h"
#include "properties/cases/generators.h"

namespace raycheck::properties {
namespace {

/// A pixel's ray, computed in plain doubles.
struct PixelAim {
  Line from_pixel;
  Line from_eye;
  double length;  ///< |P - E|
};

PixelAim aim_through(const Scene& scene, const Pixel& pixel) {
  const Camera& camera = *scene.camera;
  const auto [U, V, W] = Axes(camera);
  const auto share = [&](std::int64_t index, std::int64_t count) {
    const auto [offset, steps] = scene::pixel_steps(scene.conventions.samples, count);
    return (static_cast<double>(index) + offset) / steps;
  };
  const double down = share(pixel.j, camera.height);
  const double alpha = camera.left + share(pixel.i, camera.width) * (camera.right - camera.left);
  const double beta = scene.conventions.rows == scene::Rows::kBottomFirst
                          ? camera.bottom + down * (camera.top - camera.bottom)
                          : camera.top + down * (camera.bottom - camera.top);
  const Vector3 to_pixel = {camera.near * W.x + alpha * U.x + beta * V.x,
                            camera.near * W.y + alpha * U.y + beta * V.y,
                            camera.near * W.z + alpha * U.z + beta * V.z};
  const Vector3 direction = times(1 / length(to_pixel), to_pixel);
  const Point3 point = along(camera.eye, 1, to_pixel);
  return {{{point, direction}, direction}, {{camera.eye, direction}, direction}, length(to_pixel)};
}

/// Adds one to three spheres, each near the ray through one of the pixels, mostly ahead of the eye.
void add_aimed_spheres(Random& random, Case& result) {
  const auto count = random.integer(1, 3);
  for (std::int64_t k = 0; k < count; ++k) {
    const auto which = random.integer(0, static_cast<std::int64_t>(result.pixels.size()) - 1);
    const PixelAim aim = aim_through(result.scene, result.pixels[static_cast<std::size_t>(which)]);
    const double distance = aim.length * random.between(1.2, 4);
    const double radius = distance * random.between(0.05, 0.6);
    const double impact = radius * random.between(0, 1.6);
    const double side = random.one_in(8) ? -1 : 1;
    result.scene.spheres.push_back(
        sphere_off(random, aim.from_eye, side * distance, impact, radius));
  }
}

/// Narrow or wide, independently across and down. Sometimes the image plane is behind the eye.
Case field_of_view(int severity, std::uint64_t seed) {
  return valid_case(seed, [severity](Random& random, Case& result) {
    Camera camera = ordinary_camera(random);
    const int across = random.one_in(2) ? severity : -severity;
    const int down = random.one_in(4) ? -across : across;
    camera.left = camera.near * about_ten_to(random, across);
    camera.right = -camera.near * about_ten_to(random, across);
    camera.bottom = camera.near * about_ten_to(random, down);
    camera.top = -camera.near * about_ten_to(random, down);
    vary_bounds(random, camera);
    if (random.one_in(4)) camera.near = -camera.near;
    result.scene.camera = camera;
    result.pixels = some_pixels(random, camera);
    add_aimed_spheres(random, result);
  });
}

/// 2^31 pixels would be one too many, so the highest severity uses fewer.
constexpr int kMostPixelsLog2 = 31;

/// The first index of `count`, the last, or any.
std::int64_t any_index(Random& random, std::int64_t count) {
  const std::int64_t end = random.one_in(2) ? 0 : count - 1;
  return random.one_in(2) ? end : random.integer(0, count - 1);
}

/// Square images and wide ones. An image of one row or column cannot be sampled at edges.
Case image_size(int severity, std::uint64_t seed) {
  return valid_case(seed, [severity](Random& random, Case& result) {
    Camera camera = ordinary_camera(random);
    vary_bounds(random, camera);
    camera.width = std::min(std::int64_t{1} << severity, scene::kMostPixelsAcross);
    if (random.one_in(2)) camera.height = camera.width;
    if (random.one_in(8)) camera.height = 1;
    if (std::min(camera.width, camera.height) == 1) {
      result.scene.conventions.samples = scene::Samples::kCentres;
    }
    result.scene.camera = camera;
    const auto pixels = random.integer(1, 4);
    for (std::int64_t k = 0; k < pixels; ++k) {
      const std::int64_t i = any_index(random, camera.width);
      result.pixels.push_back({i, any_index(random, camera.height)});
    }
    add_aimed_spheres(random, result);
  });
}

/// Rays from the image plane. The first pixel's point is next to the surface of every sphere:
/// before the sphere, just inside, about to leave it, or just past it, with the sphere between eye
/// and plane.
Case near_plane(int severity, std::uint64_t seed) {
  return valid_case(seed, [severity](Random& random, Case& result) {
    result.scene.conventions.origin = scene::Origin::kPixel;
    Camera camera = ordinary_camera(random);
    const Vector3 view = camera.look_at - camera.eye;
    const double from_world = camera.near * random.power_of_ten(-3, 1);
    camera.eye = along({}, from_world, random.direction());
    camera.look_at = along(camera.eye, 1, view);
    vary_bounds(random, camera);
    result.scene.camera = camera;
    result.pixels = some_pixels(random, camera);
    const PixelAim aim = aim_through(result.scene, result.pixels.front());
    const auto count = random.integer(1, 3);
    for (std::int64_t k = 0; k < count; ++k) {
      // If the distance were much smaller than |P|, the rounding of P would change the severity.
      const double distance = (aim.length + std::abs(from_world)) * random.between(0.1, 0.5);
      const double cosine = random.between(0.3, 1);
      const double side = random.sign();
      Sphere sphere = sphere_off(random, aim.from_pixel, side * distance * cosine,
                                 distance * std::sqrt((1 - cosine) * (1 + cosine)), 0);
      const double to_centre = distance_between(aim.from_pixel.ray.origin, sphere.centre);
      sphere.radius = to_centre / (1 + signed_share_of(random, severity));
      result.scene.spheres.push_back(sphere);
    }
  });
}

// ray_cases.cpp explains how the levels were measured.
constexpr CaseSource kPixelSourceTable[] = {
    {"field-of-view", "bounds of 10^k or 10^-k times near", true,
     // The lecture's directions break from @2 on, and the sums of `incremental` at @0; the other
     // methods hold at all severities.
     SeverityRange{"log10 of the bounds over near, up or down", 10, 15, 3, 15}, field_of_view},
    {"image-size", "images 2^k pixels across, 2^31 - 1 at most", true,
     // The lecture's directions break from @6 on; the other methods hold at all severities.
     SeverityRange{"log2 of the pixels across", 2, kMostPixelsLog2, 14, kMostPixelsLog2},
     image_size},
    {"near-plane", "image planes 10^-k radii off the surface of a sphere", true,
     // All methods decide correctly, though the rounding of the pixel point adds to the roundings
     // in `surface`.
     SeverityRange{"log10 of the radius over the pixel's distance from the surface", 10, 15, 6, 15},
     near_plane}};

}  // namespace

constinit const std::span<const CaseSource> kPixelSources = kPixelSourceTable;

}  // namespace raycheck::properties
