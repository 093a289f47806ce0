#include "tools/view/document_json.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reference/visibility/visibility.h"
#include "scene/files/scene_file.h"
#include "scene/number.h"
#include "tools/explain/explain_views.h"
#include "tools/image/image_paint.h"
#include "tools/report/data_address.h"
#include "tools/report/json.h"
#include "tools/report/typeset.h"
#include "tools/report/words.h"
#include "tools/view/chart_json.h"
#include "tools/view/panel_json.h"
#include "tools/view/view_words.h"

namespace raycheck::tools {
namespace {

/// A number that is drawn; null where no double is left of it.
Json drawn(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json drawn(const Drawn& point) { return {drawn(point[0]), drawn(point[1]), drawn(point[2])}; }

Json selection_json(const Selection& selection) {
  Json json;
  json["pixel"] = selection.pixel ? Json{selection.pixel->i, selection.pixel->j} : Json(nullptr);
  json["ray"] = selection.ray ? Json(*selection.ray) : Json(nullptr);
  json["sphere"] = selection.sphere ? Json(*selection.sphere) : Json(nullptr);
  return json;
}

Json camera_json(const DrawnCamera& drawn_camera, const scene::Scene& scene) {
  const scene::Camera& camera = *scene.camera;
  return {{"U", drawn(drawn_camera.U)},
          {"V", drawn(drawn_camera.V)},
          {"W", drawn(drawn_camera.W)},
          {"look_at", drawn(drawn_camera.look_at)},
          {"up", drawn(drawn_camera.up)},
          {"near", drawn(drawn_camera.near)},
          {"far", drawn_camera.far ? drawn(*drawn_camera.far) : Json(nullptr)},
          {"left", drawn(drawn_camera.left)},
          {"right", drawn(drawn_camera.right)},
          {"bottom", drawn(drawn_camera.bottom)},
          {"top", drawn(drawn_camera.top)},
          {"width", camera.width},
          {"height", camera.height},
          {"rows", name(scene.conventions.rows)},
          {"samples", name(scene.conventions.samples)},
          {"origin", name(scene.conventions.origin)}};
}

Json figure_json(const Figure& figure, const scene::Scene& scene) {
  Json json;
  json["scale_exponent"] = figure.scale_exponent;
  json["origin_text"] =
      fmt::format("{} = ({}, {}, {})", figure.camera ? "E" : "L", scene::shortest(figure.origin.x),
                  scene::shortest(figure.origin.y), scene::shortest(figure.origin.z));
  json["camera"] = figure.camera ? camera_json(*figure.camera, scene) : Json(nullptr);
  json["rays"] = figure.rays.empty() ? Json(nullptr) : Json::array();
  for (const DrawnRay& ray : figure.rays) {
    json["rays"].push_back({{"origin", drawn(ray.origin)}, {"direction", drawn(ray.direction)}});
  }
  Json spheres = {{"centre", Json::array()},
                  {"radius", Json::array()},
                  {"colour", Json::array()},
                  {"label", Json::array()}};
  for (const DrawnSphere& sphere : figure.spheres) {
    spheres["centre"].push_back(drawn(sphere.centre));
    spheres["radius"].push_back(drawn(sphere.radius));
    spheres["colour"].push_back("#" + hex(sphere.colour));
    spheres["label"].push_back(sphere.label);
  }
  json["spheres"] = std::move(spheres);
  json["spheres_left_out"] = figure.spheres_left_out;
  return json;
}

Json picture_json(const ScenePicture& picture) {
  Json json;
  json["kind"] = name(picture.kind);
  json["name"] = picture_name(picture);
  json["png"] = data_address("image/png", picture.png);
  json["legend"] = Json::array();
  for (const LegendEntry& entry : picture.legend) {
    json["legend"].push_back({{"colour", "#" + hex(entry.colour)},
                              {"text", entry.text},
                              {"pixels", entry.pixels ? Json(*entry.pixels) : Json(nullptr)}});
  }
  return json;
}

Json drawing_json(const PanelDrawing& drawing) {
  Json json;
  json["L"] = drawn(drawing.origin);
  json["P"] = drawing.pixel ? drawn(*drawing.pixel) : Json(nullptr);
  json["D"] = drawn(drawing.direction);
  json["foot"] = drawing.foot ? drawn(*drawing.foot) : Json(nullptr);
  json["roots"] = Json::array();
  for (const DrawnRoot& root : drawing.roots) {
    json["roots"].push_back({{"which", root.smaller ? "smaller" : "larger"},
                             {"Q", drawn(root.point)},
                             {"s", digits_text(root.parameter)},
                             {"counts", root.counts},
                             {"chosen", root.is_chosen}});
  }
  return json;
}

Json panel_json(const Panel& panel) {
  Json json = selection_json(panel.selection);
  json["command"] = panel.command;
  json["text"] = panel.text;
  json.update(told_json(panel.report));
  json["drawing"] = drawing_json(panel.drawing);
  json["microscope"] = panel.microscope ? microscope_json(*panel.microscope) : Json(nullptr);
  json["sage"] = panel.sage;
  json["latex"] = panel.latex;
  return json;
}

Json scene_json(const SceneView& view) {
  Json json;
  json["name"] = view.name;
  json["command"] = view.command;
  json["toml"] = scene::write_toml(view.scene);
  json["conventions"] = conventions_json(view.scene.conventions);
  json["conventions_text"] = conventions_text(view.scene.conventions);
  json["figure"] = figure_json(view.figure, view.scene);
  json["pictures"] = Json::array();
  for (const ScenePicture& picture : view.pictures) {
    json["pictures"].push_back(picture_json(picture));
  }
  json["seen"] = view.seen.empty() ? Json(nullptr) : Json::array();
  for (const SeenRun& run : view.seen) json["seen"].push_back({run.pixels, run.sphere});
  json["start"] = selection_json(view.start);
  json["panels"] = Json::array();
  for (const Panel& panel : view.panels) json["panels"].push_back(panel_json(panel));
  return json;
}

Json finding_json(const FindingView& finding) {
  Json json = {{"sentence", finding.sentence},
               {"candidate", finding.candidate},
               {"method", finding.method},
               {"standing", finding.standing ? name(*finding.standing) : "within its bound"},
               {"looks_like", finding.looks_like},
               {"scene", finding.scene}};
  json.update(selection_json(finding.selection));
  return json;
}

Json whole(const ViewDocument& document) {
  Json json = json_header("view");
  json["title"] = document.title;
  json["scenes"] = Json::array();
  for (const SceneView& scene : document.scenes) json["scenes"].push_back(scene_json(scene));
  json["findings"] = Json::array();
  for (const FindingView& one : document.findings) json["findings"].push_back(finding_json(one));
  json["found"] = document.found;
  json["worst"] = document.worst;
  json["words"] = words_of_pages();
  json["dial"] =
      document.dial ? Json{{"sentence", document.dial->sentence}, {"scenes", document.dial->scenes}}
                    : Json(nullptr);
  json["chart"] = document.chart ? chart_json(*document.chart) : Json(nullptr);
  json["left_out"] = document.left_out;
  return json;
}

}  // namespace

std::string document_json(const ViewDocument& document) { return json_text(whole(document)); }
std::string document_line(const ViewDocument& document) { return json_line(whole(document)); }

std::string panel_line(const Panel& panel) { return json_line(panel_json(panel)); }

}  // namespace raycheck::tools
