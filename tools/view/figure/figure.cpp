#include "tools/view/figure/figure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/exact_camera.h"
#include "scene/number.h"
#include "tools/image/image_paint.h"

namespace raycheck::tools {
namespace {

/// Views of the whole scene leave out spheres that extend beyond this many times the frustum's
/// size.
constexpr double kOrdinary = 50;
/// If there are more pixels or rays, they are thinned out, and the figure says so.
constexpr std::int64_t kMostPixelsAcross = 96, kMostRaysAcross = 24;
/// If given rays times spheres is at most this, each ray is drawn to its hit.
constexpr double kMostMet = 1 << 22;
/// Doubles near a centre are |C| 2^-52 apart, so a sphere smaller than this times |C| cannot be
/// drawn.
constexpr double kLeastDrawn = 0x1p-40;

struct Figure {
  Json camera = nullptr, rays = nullptr, spheres;
  DrawnPlaces places;              ///< The places of the camera.
  double size = 0;                 ///< The extent of the frustum, or of given rays and a sphere.
  double reach = 0;                ///< The extent of a view of the whole scene.
  std::vector<Drawn> whole;        ///< The contents of that view besides spheres.
  std::vector<std::size_t> apart;  ///< The spheres that the view leaves out.
  /// Whether that view shows so little that the figure starts with the view from the eye.
  bool is_out_of_scale = false;
  std::vector<std::string> notes;  ///< Notes on what is not drawn exactly.
};

/// A camera in a drawing whose origin is the eye.
struct DrawnCamera {
  Drawn U, V, W;
  double near, left, right, bottom, top;
};

DrawnCamera drawn_camera(const scene::Camera& camera, const reference::ExactCamera& exact,
                         const DrawnFrame& frame) {
  const auto axes = exact.rounded_frame();
  return {unit(axes.U),
          unit(axes.V),
          unit(axes.W),
          frame.length(camera.near),
          frame.length(camera.left),
          frame.length(camera.right),
          frame.length(camera.bottom),
          frame.length(camera.top)};
}

/// The strides between drawn columns and rows, so that at most `most` of each are drawn.
std::array<std::int64_t, 2> steps(const scene::Camera& camera, std::int64_t most) {
  return {(camera.width + most - 1) / most, (camera.height + most - 1) / most};
}

/// The range of s that counts.
Json counts_json(const scene::Conventions& conventions, const DrawnFrame& frame) {
  const scene::ValidRoots& valid = conventions.valid;
  const bool in_radii = valid.unit == scene::TUnit::kRadius;
  const auto end = [&](double t) { return drawn(in_radii ? t : frame.length(t)); };
  return {{"from", end(valid.t_min)},
          {"to", end(valid.t_max)},
          {"in_radii", in_radii},
          {"smaller", valid.culling != scene::Culling::kFrontFaces},
          {"larger", valid.culling != scene::Culling::kBackFaces &&
                         conventions.root != scene::Root::kSmaller}};
}

/// `first`: P of pixel (0, 0).
Json camera_json(const scene::Scene& scene, const DrawnCamera& shown, const Drawn& first,
                 const DrawnFrame& frame) {
  const scene::Camera& camera = *scene.camera;
  const scene::Conventions& conventions = scene.conventions;
  const scene::PixelSteps columns = scene::pixel_steps(conventions.samples, camera.width);
  const scene::PixelSteps rows = scene::pixel_steps(conventions.samples, camera.height);
  const double across = (shown.right - shown.left) / columns.steps,
               up = (shown.top - shown.bottom) / rows.steps;
  const bool from_top = conventions.rows == scene::Rows::kTopFirst;
  // Each sample is in the middle of a cell, so that cells begin before the first sample's side of
  // the plane, and end beyond the other.
  const double before = 0.5 - columns.offset;
  const double beyond_columns = static_cast<double>(camera.width) - columns.steps - before;
  const double beyond_rows = static_cast<double>(camera.height) - rows.steps - before;
  std::array<double, 4> window = {shown.left - before * across,
                                  shown.right + beyond_columns * across,
                                  shown.bottom - (from_top ? beyond_rows : before) * up,
                                  shown.top + (from_top ? before : beyond_rows) * up};
  for (double& side : window) side /= std::abs(shown.near);
  return {{"U", drawn(shown.U)},
          {"V", drawn(shown.V)},
          {"W", drawn(shown.W)},
          {"near", drawn(shown.near)},
          {"first", drawn(first)},
          {"column", drawn(across * shown.U)},
          {"row", drawn((from_top ? -up : up) * shown.V)},
          {"window", window},
          {"width", camera.width},
          {"height", camera.height},
          {"rows", name(conventions.rows)},
          {"origin", name(conventions.origin)},
          {"pixel_steps", steps(camera, kMostPixelsAcross)},
          {"ray_steps", steps(camera, kMostRaysAcross)},
          {"counts", counts_json(conventions, frame)}};
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
  const reference::ExactCamera exact(given, scene.conventions);
  const DrawnCamera camera = drawn_camera(given, exact, frame);
  const reference::ExactRay ray(exact, {0, 0});
  const Drawn first = frame.point([&](int bits) { return ray.enclose(bits).pixel_point(); });
  figure.camera = camera_json(scene, camera, first, frame);
  const double axis = kAxisLength * std::abs(camera.near);
  figure.places = {{"E", {0, 0, 0}},       {"A", frame.point(given.look_at)},
                   {"U", axis * camera.U}, {"V", axis * camera.V},
                   {"W", axis * camera.W}, {"up", kUpLength * axis * unit(given.up)}};
  const auto near = corners(camera, camera.near);
  add_corners(figure, "near", near);
  add_corners(figure, "plane", corners(camera, camera.near, kEnlarged));
  if (given.far) add_corners(figure, "far", corners(camera, frame.length(*given.far)));
  figure.places.emplace_back("pixel (0, 0)", first);
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
        "The image plane is so narrow that it looks like a point from outside; use the view from "
        "the eye.");
  }
  const auto [across, down] = steps(given, kMostPixelsAcross);
  const auto [ray_across, ray_down] = steps(given, kMostRaysAcross);
  if (std::max(across, down) > 1) {
    figure.notes.push_back(fmt::format(
        "Of {} columns of pixels, one in {} is drawn; of {} rows, one in {}. If all rays "
        "are shown, those of one column in {} and of one row in {} are drawn.",
        given.width, across, given.height, down, ray_across, ray_down));
  }
}

void add_rays(Figure& figure, const DrawnFrame& frame, const scene::Scene& scene) {
  const double met =
      static_cast<double>(scene.rays.size()) * static_cast<double>(scene.spheres.size());
  if (met > kMostMet) figure.notes.push_back("There are too many rays to draw their hit points.");
  for (const scene::Ray& ray : scene.rays) {
    const Drawn origin = frame.point(ray.origin);
    Json hit = nullptr;
    const reference::ExactRay exact(ray);
    if (const auto nearest =
            met > kMostMet ? std::nullopt : exact.nearest(scene.spheres, scene.conventions)) {
      hit = drawn(frame.point([&](int bits) {
        return exact.enclose(bits).point(scene.spheres[nearest->index], nearest->intersection);
      }));
    }
    figure.rays.push_back(
        {{"origin", drawn(origin)}, {"direction", drawn(unit(ray.direction))}, {"hit", hit}});
    if (!is_finite(origin)) continue;
    figure.whole.push_back(origin);
    figure.size = std::max(figure.size, length_of(origin));
  }
}

/// "Sphere 3 surrounds" or "4 spheres surround".
std::string counted(const std::vector<std::size_t>& spheres, const char* one, const char* several) {
  return spheres.size() == 1 ? fmt::format("Sphere {} {}", spheres.front(), one)
                             : fmt::format("{} spheres {}", spheres.size(), several);
}

/// The number of pixels in which each sphere is the nearest; empty if unknown.
std::vector<std::uint64_t> seen_by(const std::vector<SeenRun>& seen, std::size_t spheres) {
  std::vector<std::uint64_t> pixels(seen.empty() ? 0 : spheres);
  for (const SeenRun& run : seen) {
    const auto sphere = static_cast<std::size_t>(run.sphere);
    if (run.sphere >= 0 && sphere < pixels.size()) pixels[sphere] += run.pixels;
  }
  return pixels;
}

void add_spheres(Figure& figure, const DrawnFrame& frame, const scene::Scene& scene,
                 std::size_t shown, const std::vector<SeenRun>& seen) {
  const std::vector<std::uint64_t> pixels = seen_by(seen, shown);
  for (const char* array : {"centre", "radius", "colour", "label"}) {
    figure.spheres[array] = Json::array();
  }
  std::vector<std::size_t> far_off, around, small, nowhere;
  for (std::size_t k = 0; k < shown; ++k) {
    const scene::Sphere& sphere = scene.spheres[k];
    const auto& [x, y, z] = sphere.centre;
    const Drawn centre = frame.point(sphere.centre);
    const double radius = frame.length(sphere.radius), distance = length_of(centre);
    figure.spheres["centre"].push_back(drawn(centre));
    figure.spheres["radius"].push_back(drawn(radius));
    figure.spheres["colour"].push_back("#" + hex(sphere_colour(k)));
    figure.spheres["label"].push_back(
        fmt::format("sphere {}: C = ({}, {}, {}), r = {}{}", k, scene::shortest(x),
                    scene::shortest(y), scene::shortest(z), scene::shortest(sphere.radius),
                    pixels.empty() ? "" : fmt::format("; seen by {} pixels", pixels[k])));
    if (figure.camera.is_null() && k == 0 && std::isfinite(distance + radius)) {
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
  figure.is_out_of_scale |= shown > 0 && far_off.size() + nowhere.size() == shown;
  const auto note = [&](const auto& spheres, const char* one, const char* several,
                        const char* what) {
    if (!spheres.empty()) figure.notes.push_back(counted(spheres, one, several) + what);
  };
  note(far_off, "reaches", "reach", " too far for a view of the whole; look around the sphere.");
  note(around, "surrounds", "surround", " the eye; from outside only the far half is drawn.");
  note(nowhere, "lies", "lie", " too far away for a position in doubles, and cannot be drawn.");
  note(small, "is", "are", " too small, so far from the origin, to be drawn.");
  for (const auto& spheres : {far_off, around, nowhere}) {
    figure.apart.insert(figure.apart.end(), spheres.begin(), spheres.end());
  }
  if (shown < scene.spheres.size()) {
    figure.notes.push_back(
        fmt::format("{} more spheres are not on this page.", scene.spheres.size() - shown));
  }
}

}  // namespace

Json figure_json(const scene::Scene& scene, std::size_t most_spheres,
                 const std::vector<SeenRun>& seen) {
  const DrawnFrame frame(scene);
  const auto& [x, y, z] = frame.origin();
  Figure figure;
  if (scene.camera) add_camera(figure, frame, scene);
  add_rays(figure, frame, scene);
  add_spheres(figure, frame, scene, std::min(scene.spheres.size(), most_spheres), seen);
  for (const Drawn& place : figure.whole) {
    figure.reach = std::max(figure.reach, length_of(place));
  }
  if (figure.size == 0) figure.size = 1;
  if (figure.reach == 0) figure.reach = figure.size;
  return {{"scale_exponent", frame.exponent()},
          {"origin_text", fmt::format("{} = ({}, {}, {})", scene.camera ? "E" : "L",
                                      scene::shortest(x), scene::shortest(y), scene::shortest(z))},
          {"camera", std::move(figure.camera)},
          {"rays", std::move(figure.rays)},
          {"spheres", std::move(figure.spheres)},
          {"places", places_json(figure.places)},
          {"size", drawn(figure.size)},
          {"reach", drawn(figure.reach)},
          {"whole", list_json(figure.whole, [](const Drawn& place) { return drawn(place); })},
          {"apart", figure.apart},
          {"out_of_scale", figure.is_out_of_scale},
          {"notes", figure.notes}};
}

}  // namespace raycheck::tools
