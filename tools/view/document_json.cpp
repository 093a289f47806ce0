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
#include "tools/report/json.h"
#include "tools/report/spelling.h"
#include "tools/report/typeset.h"
#include "tools/report/words.h"
#include "tools/view/chart/chart_json.h"
#include "tools/view/figure/figure_json.h"
#include "tools/view/panel/panel_json.h"
#include "tools/view/view_words.h"

namespace raycheck::tools {
namespace {

Json selection_json(const Selection& selection) {
  Json json;
  json["pixel"] = selection.pixel ? Json{selection.pixel->i, selection.pixel->j} : Json(nullptr);
  json["ray"] = selection.ray ? Json(*selection.ray) : Json(nullptr);
  json["sphere"] = selection.sphere ? Json(*selection.sphere) : Json(nullptr);
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
  json["figure"] = figure_json(view);
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
  json["parts"] = document.scenes.empty() ? Json(nullptr) : parts_json();
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
