#include "tools/view/figure/figure_json.h"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/number.h"
#include "tools/image/image_paint.h"
#include "tools/view/figure/drawn_frame.h"
#include "tools/view/figure/figure_parts.h"

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
  Json spheres = {{"centre", Json::array()},
                  {"radius", Json::array()},
                  {"colour", Json::array()},
                  {"label", Json::array()}};
  const std::vector<std::uint64_t> pixels = seen_by(view);
  for (std::size_t k = 0; k < view.figure.spheres.size(); ++k) {
    const DrawnSphere& sphere = view.figure.spheres[k];
    spheres["centre"].push_back(drawn(sphere.centre));
    spheres["radius"].push_back(drawn(sphere.radius));
    spheres["colour"].push_back("#" + hex(sphere.colour));
    spheres["label"].push_back(pixels.empty()
                                   ? sphere.label
                                   : fmt::format("{}; seen by {} pixels", sphere.label, pixels[k]));
  }
  return spheres;
}

}  // namespace

Json parts_json() {
  Json json = {{"lines", Json::array()}, {"marks", Json::array()}, {"names", Json::array()}};
  for (const PartLine& line : part_lines()) {
    json["lines"].push_back({{"layer", line.layer},
                             {"path", line.path},
                             {"colour", line.colour},
                             {"thick", line.is_thick},
                             {"dashed", line.is_dashed},
                             {"arrow", line.has_arrow}});
  }
  for (const PartMark& mark : part_marks()) {
    json["marks"].push_back({{"layer", mark.layer},
                             {"at", mark.at},
                             {"colour", mark.colour},
                             {"shape", mark.shape},
                             {"size", mark.size}});
  }
  for (const PartName& name : part_names()) {
    json["names"].push_back(
        {{"layer", name.layer}, {"at", name.at}, {"text", name.text}, {"colour", name.colour}});
  }
  return json;
}

Json figure_json(const SceneView& view) {
  const Figure& figure = view.figure;
  Json json;
  json["scale_exponent"] = figure.scale_exponent;
  json["origin_text"] =
      fmt::format("{} = ({}, {}, {})", figure.camera ? "E" : "L", scene::shortest(figure.origin.x),
                  scene::shortest(figure.origin.y), scene::shortest(figure.origin.z));
  json["camera"] = figure.camera ? camera_json(*figure.camera, view.scene) : Json(nullptr);
  json["rays"] = figure.rays.empty() ? Json(nullptr) : Json::array();
  for (const DrawnRay& ray : figure.rays) {
    json["rays"].push_back({{"origin", drawn(ray.origin)},
                            {"direction", drawn(ray.direction)},
                            {"hit", drawn(ray.hit)}});
  }
  json["spheres"] = spheres_json(view);
  json["places"] = places_json(figure.places);
  json["size"] = drawn(figure.size);
  json["reach"] = drawn(figure.reach);
  json["whole"] = Json::array();
  for (const Drawn& place : figure.whole) json["whole"].push_back(drawn(place));
  json["apart"] = figure.apart;
  json["out_of_scale"] = figure.is_out_of_scale;
  json["notes"] = figure.notes;
  return json;
}

Json drawing_json(const PanelDrawing& drawing) {
  Json json;
  json["D"] = drawn(drawing.direction);
  json["across"] = drawn(drawing.across);
  json["until"] = drawn(static_cast<float>(drawing.until));
  json["places"] = places_json(drawing.places);
  json["names"] = Json::object();
  for (const auto& [place, text] : drawing.names) json["names"][place] = text;
  return json;
}

}  // namespace raycheck::tools
