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
#include "tools/view/figure_json.h"
#include "tools/view/panel.h"

namespace raycheck::tools {
namespace {

/// A number that is told: six digits, which are right.
std::string told(double value) { return fmt::format("{:.6g}", value); }

constexpr int kDigits = 17;
std::string digits(double value) { return fmt::format("{:.{}g}", value, kDigits); }

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
  json["candidate"] = picture.candidate;
  json["png"] = data_address("image/png", picture.png);
  json["legend"] = Json::array();
  for (const LegendEntry& entry : picture.legend) {
    json["legend"].push_back({{"colour", "#" + hex(entry.colour)},
                              {"text", entry.text},
                              {"pixels", entry.pixels ? Json(*entry.pixels) : Json(nullptr)}});
  }
  return json;
}

/// How many characters of a value's decimals are right: all of them within an ulp of the exact one,
/// correctly rounded, and otherwise up to the last digit to which both round alike.
std::size_t right_characters(double value, double exact) {
  const std::string text = digits(value);
  const bool is_next = value == std::nextafter(exact, value);
  if (value == exact || is_next) return text.size();
  if (!std::isfinite(value) || !std::isfinite(exact) || exact == 0) return 0;
  int right = kDigits;
  while (right > 0 &&
         fmt::format("{:.{}e}", value, right - 1) != fmt::format("{:.{}e}", exact, right - 1)) {
    --right;
  }
  if (right == 0) return 0;
  std::size_t at = 0;
  bool is_leading = true;
  for (; at < text.size() && text[at] != 'e'; ++at) {
    if (text[at] == '-' || text[at] == '.' || (is_leading && text[at] == '0')) continue;
    is_leading = false;
    if (right-- == 0) break;
  }
  return at;
}

Json method_json(const MethodReport& method, const MethodStep& mine, const Step& step) {
  Json json;
  json["name"] = method.name;
  json["value"] = Json::array();
  json["right_digits"] = Json::array();
  for (std::size_t k = 0; k < mine.value.size(); ++k) {
    json["value"].push_back(digits(mine.value[k]));
    json["right_digits"].push_back(
        k < step.rounded.size() ? right_characters(mine.value[k], step.rounded[k]) : 0);
  }
  json["error"] = mine.error ? Json(error_text(mine.error)) : Json(nullptr);
  json["unit"] = mine.unit;
  json["alone"] = mine.error_alone ? Json(error_text(mine.error_alone)) : Json(nullptr);
  json["wrong"] = method.goes_wrong_at == step.symbol;
  return json;
}

Json step_json(const Step& step, const ExplainReport& report) {
  Json json;
  json["symbol"] = step.symbol;
  json["formula"] = step.formula;
  json["mathml"] =
      is_typeset(step) ? Json("<math>" + mathml(step.closed_form) + "</math>") : Json(nullptr);
  json["latex"] = is_typeset(step) ? Json(latex(step.closed_form)) : Json(nullptr);
  json["rounded"] = Json::array();
  for (const double value : step.rounded) json["rounded"].push_back(digits(value));
  const auto condition = [](const std::optional<double>& value) {
    return value ? Json(error_text(value)) : Json(nullptr);
  };
  json["condition"] = condition(step.condition);
  json["condition_alone"] = condition(step.condition_alone);
  json["methods"] = Json::array();
  for (const MethodReport& method : report.methods) {
    for (const MethodStep& mine : method.steps) {
      if (mine.symbol == step.symbol) json["methods"].push_back(method_json(method, mine, step));
    }
  }
  return json;
}

Json microscope_json(const Microscope& microscope) {
  Json json;
  json["hit"] = microscope.is_hit;
  json["s"] = digits(microscope.parameter);
  json["ulp"] = fmt::format("{:.3g}", microscope.ulp);
  json["zooms"] = Json::array();
  for (const Microscope::Zoom& zoom : microscope.zooms) {
    Json curve = Json::array();
    for (const auto& [x, y] : zoom.curve) curve.push_back({told(x), told(y)});
    json["zooms"].push_back({{"half", told(zoom.half_width)}, {"curve", std::move(curve)}});
  }
  json["grid"] = Json::array();
  for (const double x : microscope.grid) json["grid"].push_back(told(x));
  json["region"] = microscope.region ? Json(told(*microscope.region)) : Json(nullptr);
  json["marks"] = Json::array();
  for (const MicroscopeMark& mark : microscope.marks) {
    json["marks"].push_back({{"name", mark.method},
                             {"kind", mark.is_point ? "Q" : "s"},
                             {"x", told(mark.x)},
                             {"y", told(mark.y)},
                             {"wrong", mark.is_wrong},
                             {"text", mark.text}});
  }
  return json;
}

/// What a method comes to, held against the exact answer.
Json verdict_json(const MethodReport& method, const ExplainReport& report) {
  Json json;
  json["name"] = method.name;
  json["text"] = method_verdict(method, report);
  json["intersects"] = method.intersects;
  json["wrong"] = !method.goes_wrong_at.empty() || !method.failure.empty();
  json["goes_wrong_at"] = method.goes_wrong_at;
  json["value"] = Json::array();
  json["right_digits"] = Json::array();
  if (method.intersects && method.parameter) {
    const std::optional<double>& exact = report.spheres[*report.sphere].parameter;
    json["value"].push_back(digits(*method.parameter));
    json["right_digits"].push_back(exact ? right_characters(*method.parameter, *exact) : 0);
  }
  json["error"] = method.ulp_error ? Json(error_text(method.ulp_error)) : Json(nullptr);
  json["unit"] = unit_name(properties::Quantity::kParameter, method.precision);
  return json;
}

Json panel_json(const Panel& panel) {
  const ExplainReport& report = panel.report;
  Json json = selection_json(panel.selection);
  json["command"] = panel.command;
  json["text"] = panel.text;
  json["steps"] = Json::array();
  for (const Step& step : report.steps) json["steps"].push_back(step_json(step, report));
  json["verdicts"] = Json::array();
  for (const MethodReport& method : report.methods) {
    json["verdicts"].push_back(verdict_json(method, report));
  }
  if (report.sphere) {
    const SphereReport& exact = report.spheres[*report.sphere];
    json["exact"] = {{"class", name(exact.intersection.hit_class)},
                     {"s", exact.parameter ? Json(digits(*exact.parameter)) : Json(nullptr)}};
  } else {
    json["exact"] = nullptr;
  }
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
               {"standing", finding.standing ? Json(name(*finding.standing)) : Json(nullptr)},
               {"scene", finding.scene}};
  json.update(selection_json(finding.selection));
  return json;
}

Json dial_json(const DialView& dial) {
  Json json = {{"family", dial.family},
               {"sentence", dial.sentence},
               {"unit", dial.unit},
               {"severities", dial.severities},
               {"scenes", dial.scenes}};
  json["curves"] = Json::array();
  for (const DialCurve& curve : dial.curves) {
    Json points = Json::array();
    for (const DialCurve::Point& point : curve.points) {
      points.push_back({{"severity", point.severity},
                        {"error", error_json(point.error)},
                        {"wrong", point.wrong},
                        {"stable", point.is_stable}});
    }
    json["curves"].push_back({{"name", curve.method}, {"points", std::move(points)}});
  }
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
  json["dial"] = document.dial ? dial_json(*document.dial) : Json(nullptr);
  json["chart"] = document.chart ? chart_json(*document.chart) : Json(nullptr);
  json["left_out"] = document.left_out;
  return json;
}

}  // namespace

std::string document_json(const ViewDocument& document) { return json_text(whole(document)); }
std::string document_line(const ViewDocument& document) { return json_line(whole(document)); }

std::string panel_line(const Panel& panel) { return json_line(panel_json(panel)); }

}  // namespace raycheck::tools
