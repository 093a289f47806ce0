#include <nlohmann/json.hpp>

#include "scene/number.h"
#include "tools/explain/explain.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

Json form_or_null(const std::optional<reference::ClosedForm>& form) {
  return or_null(form, [](const reference::ClosedForm& one) { return one.text(); });
}

Json left_out_json(const RootLeftOut& root) {
  return {{"root", name(root.root)}, {"s", scene::hexfloat(root.s)}, {"why", name(root.why)}};
}

Json sphere_json(const SphereReport& sphere) {
  const bool miss = !sphere.parameter;
  Json json;
  json["class"] = name(sphere.intersection.hit_class);
  json["root"] = miss ? Json(nullptr) : Json(name(sphere.intersection.root));
  json["s"] = hexfloat_or_null(sphere.parameter);
  json["left_out"] = list_json(sphere.left_out, left_out_json);
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

Json method_step_json(const MethodStep& step) {
  return {{"symbol", step.symbol},
          {"value", hexfloats(step.value)},
          {"error", error_json(step.error)},
          {"error_alone", error_json(step.error_alone)},
          {"unit", step.unit}};
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
  json["spheres"] = list_json(report.spheres, sphere_json);
  json["nearest"] = or_null(report.nearest);
  return json;
}

Json exact_ray_json(const ExplainReport& report) {
  const SphereReport& sphere = report.spheres.front();
  Json json;
  json["class"] = name(sphere.intersection.hit_class);
  json["s"] = hexfloat_or_null(sphere.parameter);
  json["left_out"] = list_json(sphere.left_out, left_out_json);
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
  json["sphere"] = or_null(report.sphere);
  json["exact"] = report.pixel ? exact_pixel_json(report) : exact_ray_json(report);
  json["exact"]["by_every_root"] = or_null(report.by_every_root, sphere_json);
  json["exact"]["steps"] = list_json(report.steps, step_json);
  json["methods"] = Json::array();
  json["ray_methods"] = Json::array();
  for (const MethodReport& method : report.methods) {
    Json entry = method.intersects ? method_json(method) : Json{{"name", method.name}};
    entry["goes_wrong_at"] = text_or_null(method.goes_wrong_at);
    entry["failed"] = text_or_null(method.failure());
    entry["steps"] = list_json(method.steps, method_step_json);
    json[method.intersects ? "methods" : "ray_methods"].push_back(std::move(entry));
  }
  return json_text(json);
}

}  // namespace raycheck::tools
