#include <nlohmann/json.hpp>

#include "scene/number.h"
#include "tools/explain/explain.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

Json form_or_null(const std::optional<reference::ClosedForm>& form) {
  return form ? Json(form->text()) : Json(nullptr);
}

Json left_out_json(const std::vector<RootLeftOut>& roots) {
  Json json = Json::array();
  for (const RootLeftOut& root : roots) {
    json.push_back(
        {{"root", name(root.root)}, {"s", scene::hexfloat(root.s)}, {"why", name(root.why)}});
  }
  return json;
}

Json sphere_json(const SphereReport& sphere) {
  const bool miss = !sphere.parameter;
  Json json;
  json["class"] = name(sphere.intersection.hit_class);
  json["root"] = miss ? Json(nullptr) : Json(name(sphere.intersection.root));
  json["s"] = hexfloat_or_null(sphere.parameter);
  json["left_out"] = left_out_json(sphere.left_out);
  json["point"] = miss ? Json(nullptr) : hexfloats(sphere.point);
  json["closed_form"] = {
      {"s", form_or_null(sphere.closed_form_parameter)},
      {"point", miss ? Json(nullptr) : Json(reference::texts(sphere.closed_form_point))}};
  return json;
}

Json step_json(const Step& step) {
  return {{"symbol", step.symbol},
          {"formula", step.formula},
          {"closed_form", reference::texts(step.closed_form)},
          {"rounded", hexfloats(step.rounded)},
          {"condition", error_json(step.condition)},
          {"condition_alone", error_json(step.condition_alone)}};
}

Json method_json(const MethodReport& method) {
  Json json;
  json["name"] = method.name;
  json["hit"] = method.parameter.has_value();
  json["s"] = hexfloat_or_null(method.parameter);
  json["ulp_error"] = error_json(method.ulp_error);
  json["unit"] = unit_name(properties::Quantity::kParameter, method.precision);
  json["excluded_by_own_interval"] = method.is_excluded();
  json["class_error"] = method.wrong && method.wrong->quantity == properties::Quantity::kClass;
  json["standing"] = method.wrong ? Json(name(method.wrong->excuse.standing())) : Json(nullptr);
  return json;
}

void add_steps(const MethodReport& method, Json& json) {
  json["goes_wrong_at"] = method.goes_wrong_at.empty() ? Json(nullptr) : Json(method.goes_wrong_at);
  json["failed"] = method.failure().empty() ? Json(nullptr) : Json(method.failure());
  json["steps"] = Json::array();
  for (const MethodStep& step : method.steps) {
    json["steps"].push_back({{"symbol", step.symbol},
                             {"value", hexfloats(step.value)},
                             {"error", error_json(step.error)},
                             {"error_alone", error_json(step.error_alone)},
                             {"unit", step.unit}});
  }
}

Json exact_pixel_json(const ExplainReport& report) {
  Json json;
  Json closed_form;
  const auto add = [&](const char* name, const char* symbol) {
    const Step& step = *report.find(symbol);
    json[name] = hexfloats(step.rounded);
    closed_form[name] = reference::texts(step.closed_form);
  };
  add("pixel_point", "P");
  add("direction", "D");
  add("U", "U");
  add("V", "V");
  add("W", "W");
  json["closed_form"] = std::move(closed_form);
  json["spheres"] = Json::array();
  for (const SphereReport& sphere : report.spheres) json["spheres"].push_back(sphere_json(sphere));
  json["nearest"] = report.nearest ? Json(*report.nearest) : Json(nullptr);
  return json;
}

Json exact_ray_json(const ExplainReport& report) {
  const SphereReport& sphere = report.spheres.front();
  Json json;
  json["class"] = name(sphere.intersection.hit_class);
  json["s"] = hexfloat_or_null(sphere.parameter);
  json["left_out"] = left_out_json(sphere.left_out);
  json["closed_form"] = form_or_null(sphere.closed_form_parameter);
  json["point"] = sphere.parameter ? hexfloats(sphere.point) : Json(nullptr);
  json["closed_form_point"] =
      sphere.parameter ? Json(reference::texts(sphere.closed_form_point)) : Json(nullptr);
  return json;
}

}  // namespace

std::string explain_json(const ExplainReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("explain");
  json["conventions"] = conventions_json(report.scene.conventions);
  json["isolated_by"] = report.other ? Json(report.other->isolated_by) : Json(nullptr);
  json["bounds_of"] = report.other ? text_or_null(report.other->bounds_of) : Json(nullptr);
  json["rounded_numbers"] = report.rounded_numbers;
  if (report.pixel) json["pixel"] = {report.pixel->i, report.pixel->j};
  json["sphere"] = report.sphere ? Json(*report.sphere) : Json(nullptr);
  json["exact"] = report.pixel ? exact_pixel_json(report) : exact_ray_json(report);
  json["exact"]["by_every_root"] =
      report.by_every_root ? sphere_json(*report.by_every_root) : Json(nullptr);
  json["exact"]["steps"] = Json::array();
  for (const Step& step : report.steps) json["exact"]["steps"].push_back(step_json(step));
  json["methods"] = Json::array();
  json["ray_methods"] = Json::array();
  for (const MethodReport& method : report.methods) {
    Json entry = method.intersects ? method_json(method) : Json{{"name", method.name}};
    add_steps(method, entry);
    json[method.intersects ? "methods" : "ray_methods"].push_back(std::move(entry));
  }
  return json_text(json);
}

}  // namespace raycheck::tools
