#include <fmt/core.h>

#include <cmath>

#include "scene/number.h"
#include "tools/image/image_paint.h"
#include "tools/view/figure/drawn_frame.h"
#include "tools/view/figure/figure.h"

namespace raycheck::tools {
namespace {

/// A number that is drawn; null where no double is left of it.
Json drawn(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json drawn(const Drawn& point) { return is_finite(point) ? Json(point) : Json(nullptr); }
Json drawn(const std::optional<Drawn>& point) { return point ? drawn(*point) : Json(nullptr); }

Json places_json(const DrawnPlaces& places) {
  Json json = Json::object();
  for (const auto& [name, place] : places) json[name] = drawn(place);
  return json;
}

Json camera_json(const DrawnCamera& drawn_camera, const scene::Scene& scene) {
  const scene::Camera& camera = *scene.camera;
  return {{"U", drawn(drawn_camera.U)},
          {"V", drawn(drawn_camera.V)},
          {"W", drawn(drawn_camera.W)},
          {"near", drawn(drawn_camera.near)},
          {"first", drawn(drawn_camera.first)},
          {"column", drawn(drawn_camera.column)},
          {"row", drawn(drawn_camera.row)},
          {"window", drawn_camera.window},
          {"width", camera.width},
          {"height", camera.height},
          {"rows", name(scene.conventions.rows)},
          {"origin", name(scene.conventions.origin)},
          {"pixel_steps", drawn_camera.pixel_steps},
          {"ray_steps", drawn_camera.ray_steps},
          {"counts",
           {{"from", drawn(drawn_camera.counts_from)},
            {"to", drawn(drawn_camera.counts_to)},
            {"in_radii", drawn_camera.in_radii},
            {"smaller", drawn_camera.smaller_counts},
            {"larger", drawn_camera.larger_counts}}}};
}

/// Of each sphere how many pixels see it; empty where that is not known.
std::vector<std::uint64_t> seen_by(const SceneView& view) {
  std::vector<std::uint64_t> pixels(view.seen.empty() ? 0 : view.figure.spheres.size());
  for (const SeenRun& run : view.seen) {
    const auto sphere = static_cast<std::size_t>(run.sphere);
    if (run.sphere >= 0 && sphere < pixels.size()) pixels[sphere] += run.pixels;
  }
  return pixels;
}

Json spheres_json(const SceneView& view) {
  const std::vector<DrawnSphere>& spheres = view.figure.spheres;
  const std::vector<std::uint64_t> pixels = seen_by(view);
  const auto label = [&](const DrawnSphere& sphere) {
    const auto k = static_cast<std::size_t>(&sphere - spheres.data());
    return pixels.empty() ? sphere.label
                          : fmt::format("{}; seen by {} pixels", sphere.label, pixels[k]);
  };
  return {
      {"centre", list_json(spheres, [](const DrawnSphere& one) { return drawn(one.centre); })},
      {"radius", list_json(spheres, [](const DrawnSphere& one) { return drawn(one.radius); })},
      {"colour", list_json(spheres, [](const DrawnSphere& one) { return "#" + hex(one.colour); })},
      {"label", list_json(spheres, label)}};
}

Json ray_json(const DrawnRay& ray) {
  return {
      {"origin", drawn(ray.origin)}, {"direction", drawn(ray.direction)}, {"hit", drawn(ray.hit)}};
}

Json line_json(const PartLine& line) {
  return {{"layer", line.layer},    {"path", line.path},        {"colour", line.colour},
          {"thick", line.is_thick}, {"dashed", line.is_dashed}, {"arrow", line.has_arrow}};
}

Json mark_json(const PartMark& mark) {
  return {{"layer", mark.layer},
          {"at", mark.at},
          {"colour", mark.colour},
          {"shape", mark.shape},
          {"size", mark.size}};
}

Json name_json(const PartName& name) {
  return {{"layer", name.layer}, {"at", name.at}, {"text", name.text}, {"colour", name.colour}};
}

}  // namespace

Json parts_json() {
  return {{"lines", list_json(part_lines(), line_json)},
          {"marks", list_json(part_marks(), mark_json)},
          {"names", list_json(part_names(), name_json)}};
}

Json figure_json(const SceneView& view) {
  const Figure& figure = view.figure;
  const auto& [x, y, z] = figure.origin;
  return {{"scale_exponent", figure.scale_exponent},
          {"origin_text", fmt::format("{} = ({}, {}, {})", figure.camera ? "E" : "L",
                                      scene::shortest(x), scene::shortest(y), scene::shortest(z))},
          {"camera", or_null(figure.camera,
                             [&](const DrawnCamera& one) { return camera_json(one, view.scene); })},
          {"rays", figure.rays.empty() ? Json(nullptr) : list_json(figure.rays, ray_json)},
          {"spheres", spheres_json(view)},
          {"places", places_json(figure.places)},
          {"size", drawn(figure.size)},
          {"reach", drawn(figure.reach)},
          {"whole", list_json(figure.whole, [](const Drawn& place) { return drawn(place); })},
          {"apart", figure.apart},
          {"out_of_scale", figure.is_out_of_scale},
          {"notes", figure.notes}};
}

Json drawing_json(const PanelDrawing& drawing) {
  Json names = Json::object();
  for (const auto& [place, text] : drawing.names) names[place] = text;
  return {{"D", drawn(drawing.direction)},
          {"across", drawn(drawing.across)},
          {"until", drawn(static_cast<float>(drawing.until))},
          {"places", places_json(drawing.places)},
          {"names", std::move(names)}};
}

}  // namespace raycheck::tools
