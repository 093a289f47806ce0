#include "tools/view/figure/figure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "reference/exact_camera.h"
#include "scene/number.h"
#include "tools/image/image_paint.h"

namespace raycheck::tools {
namespace {

/// Views of the whole leave out what extends beyond this many times the frustum's size.
constexpr double kOrdinary = 50;
/// More are thinned out, and the figure says so.
constexpr std::int64_t kMostPixelsAcross = 96, kMostRaysAcross = 24;
/// Up to this many given rays times spheres each ray is drawn to its hit.
constexpr double kMostMet = 1 << 22;
/// Doubles near a centre are |C| 2^-52 apart: a sphere smaller than this times |C| cannot be drawn.
constexpr double kLeastDrawn = 0x1p-40;

DrawnCamera drawn_camera(const scene::Scene& scene, const DrawnFrame& frame) {
  const scene::Camera& camera = *scene.camera;
  const auto axes = reference::ExactCamera(camera, scene.conventions).rounded_frame();
  DrawnCamera drawn;
  drawn.U = unit(axes.U);
  drawn.V = unit(axes.V);
  drawn.W = unit(axes.W);
  drawn.near = frame.length(camera.near);
  drawn.left = frame.length(camera.left);
  drawn.right = frame.length(camera.right);
  drawn.bottom = frame.length(camera.bottom);
  drawn.top = frame.length(camera.top);
  const bool at_edges = scene.conventions.samples == scene::Samples::kEdges;
  const double columns = static_cast<double>(camera.width - (at_edges ? 1 : 0));
  const double rows = static_cast<double>(camera.height - (at_edges ? 1 : 0));
  const double across = (drawn.right - drawn.left) / columns,
               up = (drawn.top - drawn.bottom) / rows;
  const bool from_top = scene.conventions.rows == scene::Rows::kTopFirst;
  const reference::ExactRay first(reference::ExactCamera(camera, scene.conventions), {0, 0});
  drawn.first = frame.point([&](int bits) { return first.enclose(bits).pixel_point(); });
  drawn.column = across * drawn.U;
  drawn.row = (from_top ? -up : up) * drawn.V;
  const double beside = at_edges ? 0.5 : 0;  // of a cell, so that each sample's cell is whole
  drawn.window = {drawn.left - beside * across, drawn.right + beside * across,
                  drawn.bottom - beside * up, drawn.top + beside * up};
  for (double& side : drawn.window) side /= std::abs(drawn.near);
  const auto steps = [&](std::int64_t most) {
    return std::array{(camera.width + most - 1) / most, (camera.height + most - 1) / most};
  };
  drawn.pixel_steps = steps(kMostPixelsAcross);
  drawn.ray_steps = steps(kMostRaysAcross);
  const scene::ValidRoots& valid = scene.conventions.valid;
  drawn.in_radii = valid.unit == scene::TUnit::kRadius;
  drawn.counts_from = drawn.in_radii ? valid.t_min : frame.length(valid.t_min);
  drawn.counts_to = drawn.in_radii ? valid.t_max : frame.length(valid.t_max);
  drawn.smaller_counts = valid.culling != scene::Culling::kFrontFaces;
  drawn.larger_counts = valid.culling != scene::Culling::kBackFaces &&
                        scene.conventions.root != scene::Root::kSmaller;
  return drawn;
}

/// The corners of the frustum at a depth, enlarged about its middle.
std::array<Drawn, 4> corners(const DrawnCamera& camera, double depth, double enlarged = 1) {
  const auto at = [&](double low, double high, int sign) {
    return (low / 2 + high / 2 + sign * enlarged * (high / 2 - low / 2)) * (depth / camera.near);
  };
  const auto corner = [&](int x, int y) {
    return at(camera.left, camera.right, x) * camera.U +
           at(camera.bottom, camera.top, y) * camera.V + depth * camera.W;
  };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

void add_corners(Figure& figure, const std::string& plane, const std::array<Drawn, 4>& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    figure.places.emplace_back(fmt::format("{} {}", plane, k), corners[k]);
  }
}

void add_camera(Figure& figure, const DrawnFrame& frame, const scene::Scene& scene) {
  constexpr double kEnlarged = 1.5;                      // the view plane, partly drawn
  constexpr double kAxisLength = 0.4, kUpLength = 1.35;  // of the plane's distance; of an axis
  const scene::Camera& given = *scene.camera;
  const DrawnCamera& camera = *(figure.camera = drawn_camera(scene, frame));
  const double axis = kAxisLength * std::abs(camera.near);
  figure.places = {{"E", {0, 0, 0}},       {"A", frame.point(given.look_at)},
                   {"U", axis * camera.U}, {"V", axis * camera.V},
                   {"W", axis * camera.W}, {"up", kUpLength * axis * unit(given.up)}};
  const auto near = corners(camera, camera.near);
  add_corners(figure, "near", near);
  add_corners(figure, "plane", corners(camera, camera.near, kEnlarged));
  if (given.far) add_corners(figure, "far", corners(camera, frame.length(*given.far)));
  figure.places.emplace_back("pixel (0, 0)", camera.first);
  std::erase_if(figure.places, [](const auto& place) { return !is_finite(place.second); });
  for (const auto& [name, place] : figure.places) {
    if (name.starts_with(given.far ? "far" : "near")) {
      figure.size = std::max(figure.size, length_of(place));
    }
  }
  for (const auto& [name, place] : figure.places) {
    const bool is_whole = name != "A" || length_of(place) <= kOrdinary * figure.size;
    if (is_whole && !name.starts_with("plane")) figure.whole.push_back(place);
  }
  if (length_of(near[0] - near[2]) < length_of(near[0]) / kOrdinary) {
    figure.is_out_of_scale = true;
    figure.notes.push_back(
        "From outside the image plane is next to a point, so narrow it is; the view from the eye "
        "shows it.");
  }
  const auto& [across, down] = camera.pixel_steps;
  if (std::max(across, down) > 1) {
    figure.notes.push_back(fmt::format(
        "Of {} columns of pixels one in {} is drawn, of {} rows one in {}; when all rays are, one "
        "in {} and one in {}.",
        given.width, across, given.height, down, camera.ray_steps[0], camera.ray_steps[1]));
  }
}

void add_rays(Figure& figure, const DrawnFrame& frame, const scene::Scene& scene) {
  const double met =
      static_cast<double>(scene.rays.size()) * static_cast<double>(scene.spheres.size());
  if (met > kMostMet) figure.notes.push_back("Rays are drawn without their hit points: too many.");
  for (const scene::Ray& ray : scene.rays) {
    DrawnRay drawn = {frame.point(ray.origin), unit(ray.direction), {}};
    const reference::ExactRay exact(ray);
    if (const auto nearest =
            met > kMostMet ? std::nullopt : exact.nearest(scene.spheres, scene.conventions)) {
      drawn.hit = frame.point([&](int bits) {
        return exact.enclose(bits).point(scene.spheres[nearest->index], nearest->intersection);
      });
    }
    figure.rays.push_back(drawn);
    if (!is_finite(drawn.origin)) continue;
    figure.whole.push_back(drawn.origin);
    figure.size = std::max(figure.size, length_of(drawn.origin));
  }
}

/// "Sphere 3 surrounds" or "4 spheres surround".
std::string counted(const std::vector<std::size_t>& spheres, const char* one, const char* several) {
  return spheres.size() == 1 ? fmt::format("Sphere {} {}", spheres.front(), one)
                             : fmt::format("{} spheres {}", spheres.size(), several);
}

void add_spheres(Figure& figure, const DrawnFrame& frame, const scene::Scene& scene,
                 std::size_t drawn) {
  std::vector<std::size_t> far_off, around, small, nowhere;
  for (std::size_t k = 0; k < drawn; ++k) {
    const scene::Sphere& sphere = scene.spheres[k];
    const Drawn centre = frame.point(sphere.centre);
    const double radius = frame.length(sphere.radius), distance = length_of(centre);
    figure.spheres.push_back(
        {centre, radius, sphere_colour(k),
         fmt::format("sphere {}: C = ({}, {}, {}), r = {}", k, scene::shortest(sphere.centre.x),
                     scene::shortest(sphere.centre.y), scene::shortest(sphere.centre.z),
                     scene::shortest(sphere.radius))});
    if (!figure.camera && k == 0 && std::isfinite(distance + radius)) {
      figure.size = std::max({figure.size, distance, radius});
    }
    if (!std::isfinite(distance + radius)) {
      nowhere.push_back(k);
      continue;
    }
    if (radius < kLeastDrawn * distance) small.push_back(k);
    if (distance + radius > kOrdinary * figure.size) {
      far_off.push_back(k);
    } else if (distance < radius) {
      around.push_back(k);
    } else {
      figure.reach = std::max(figure.reach, distance + radius);
    }
  }
  figure.is_out_of_scale |= drawn > 0 && far_off.size() + nowhere.size() == drawn;
  const auto note = [&](const auto& spheres, const char* one, const char* several,
                        const char* what) {
    if (!spheres.empty()) figure.notes.push_back(counted(spheres, one, several) + what);
  };
  note(far_off, "reaches", "reach", " too far for a view of the whole; look around the sphere.");
  note(around, "surrounds", "surround", " the eye; from outside only the far half is drawn.");
  note(nowhere, "lies", "lie", " so far away that no double holds where, and cannot be drawn.");
  note(small, "is", "are", " too small, so far from the origin, to be drawn at any scale.");
  for (const auto& spheres : {far_off, around, nowhere}) {
    figure.apart.insert(figure.apart.end(), spheres.begin(), spheres.end());
  }
  if (drawn < scene.spheres.size()) {
    figure.notes.push_back(
        fmt::format("{} more spheres are not in this page.", scene.spheres.size() - drawn));
  }
}

}  // namespace

Figure figure_of(const scene::Scene& scene, std::size_t most_spheres) {
  const DrawnFrame frame(scene);
  Figure figure;
  figure.origin = frame.origin();
  figure.scale_exponent = frame.exponent();
  if (scene.camera) add_camera(figure, frame, scene);
  add_rays(figure, frame, scene);
  const std::size_t drawn = std::min(scene.spheres.size(), most_spheres);
  figure.spheres_left_out = scene.spheres.size() - drawn;
  add_spheres(figure, frame, scene, drawn);
  for (const Drawn& place : figure.whole) {
    figure.reach = std::max(figure.reach, length_of(place));
  }
  if (figure.size == 0) figure.size = 1;
  if (figure.reach == 0) figure.reach = figure.size;
  return figure;
}

}  // namespace raycheck::tools
