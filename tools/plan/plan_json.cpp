#include "tools/plan/plan.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

Json item_json(const PlanItem& item, const ItemReport& report) {
  Json json;
  json["name"] = item.name;
  json["sentence"] = item.sentence;
  json["left_out"] = report.left_out;
  json["of"] = report.of;
  json["noun"] = report.noun;
  json["why"] = report.why;
  const auto timed = [&](auto PlanTime::*member) {
    return or_null(report.time, [&](const PlanTime& time) { return time.*member; });
  };
  json["with_plan_ms"] = timed(&PlanTime::with_plan_ms);
  json["without_ms"] = timed(&PlanTime::without_ms);
  json["pixels_timed"] = timed(&PlanTime::pixels);
  return json;
}

Json sphere_json(const scene::SpherePlan& sphere) {
  const scene::PixelRectangle& pixels = sphere.pixels;
  Json json;
  json["left_out"] = or_null(sphere.left_out, [](auto why) {
    return scene::kLeftOutNames[static_cast<std::size_t>(why)];
  });
  json["hidden_by"] = or_null(sphere.hidden_by);
  json["columns"] = Json{pixels.i_begin, pixels.i_end};
  json["rows"] = Json{pixels.j_begin, pixels.j_end};
  json["pixels"] = pixels.count();
  json["far_root"] = sphere.origin_inside;
  json["behind_test"] = sphere.reaches_behind;
  return json;
}

}  // namespace

std::string plan_json(const PlanReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("plan");
  add_scene(json, report.path, report.scene);
  json["conventions"] = conventions_json(report.scene.conventions);
  json["dialect"] = dialect_json(report.dialect);
  json["not_needed"] = report.not_needed;
  json["warnings"] = report.warnings;
  json["interrupted"] = report.interrupted;
  json["items"] = Json::array();
  json["spheres"] = Json::array();
  if (!report.plan) {
    json["wanted"] = nullptr;
    json["no_plan"] = "a plan needs a camera, since only its rays share computations";
    return json_text(json);
  }
  json["wanted"] = scene::kWantedNames[static_cast<std::size_t>(report.plan->wanted)];
  json["no_plan"] = nullptr;
  json["plan_ms"] = report.plan_ms;
  json["image_ms"] = error_json(report.image_ms);
  json["pixels_timed"] = report.pixels_timed;
  json["decided_by"] = decided_by_json(report.decided_by);
  for (std::size_t k = 0; k < kPlanItems.size(); ++k) {
    json["items"].push_back(item_json(kPlanItems[k], report.items[k]));
  }
  json["spheres"] = list_json(report.plan->spheres, sphere_json);
  return json_text(json);
}

}  // namespace raycheck::tools
