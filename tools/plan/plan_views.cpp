#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tools/plan/plan.h"
#include "tools/report/json.h"
#include "tools/report/table.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using scene::SpherePlan;

std::string milliseconds(double ms) { return fmt::format("{:.3g}", ms); }

/// "saves 73%"; if the share is negative, the item costs time here.
std::string share_text(const PlanTime& time) {
  return fmt::format("{}%", std::lround(100 * (1 - time.with_plan_ms / time.without_ms)));
}

std::string left_out_text(const ItemReport& item) {
  // There is only one scene or camera.
  if (item.noun == "scene" || item.noun == "camera") return item.left_out == 1 ? "yes" : "no";
  return fmt::format("{} of {} {}", item.left_out, item.of, item.noun);
}

std::string items_table(const PlanReport& report) {
  Table table({"item", "skipped", ">ms if skipped", ">ms if done", ">saves", "why"});
  for (std::size_t k = 0; k < kPlanItems.size(); ++k) {
    const ItemReport& item = report.items[k];
    const bool is_estimate = kPlanItems[k].member == &scene::PlanItems::filter && item.time;
    std::string why = item.why;
    if (is_estimate) why += fmt::format("; timed on {}", count_text(item.time->pixels, "pixel"));
    table.add({std::string(kPlanItems[k].name), left_out_text(item),
               item.time ? milliseconds(item.time->with_plan_ms) : "-",
               item.time ? (is_estimate ? "~" : "") + milliseconds(item.time->without_ms) : "-",
               item.time ? share_text(*item.time) : "-", why});
  }
  return table.text();
}

std::string range_text(std::int64_t begin, std::int64_t end) {
  return fmt::format("{}..{}", begin, end - 1);
}

std::string spheres_table(const PlanReport& report) {
  Table table({">sphere", ">columns", ">rows", ">pixels", "far root", "behind test", "left out"});
  const std::vector<SpherePlan>& spheres = report.plan->spheres;
  const std::size_t shown = std::min(report.top, spheres.size());
  for (std::size_t k = 0; k < shown; ++k) {
    const SpherePlan& sphere = spheres[k];
    if (sphere.left_out) {
      std::string how(scene::kLeftOutNames[static_cast<std::size_t>(*sphere.left_out)]);
      if (sphere.hidden_by) how += fmt::format(" by sphere {}", *sphere.hidden_by);
      table.add({std::to_string(k), "-", "-", "0", "-", "-", how});
      continue;
    }
    const scene::PixelRectangle& pixels = sphere.pixels;
    table.add({std::to_string(k), range_text(pixels.i_begin, pixels.i_end),
               range_text(pixels.j_begin, pixels.j_end), std::to_string(pixels.count()),
               sphere.origin_inside ? "needed" : "no", sphere.reaches_behind ? "needed" : "no",
               ""});
  }
  if (table.empty()) return "";
  std::string text = "\n" + table.text();
  if (shown < spheres.size()) {
    text += fmt::format("  and {}; --top N shows more\n",
                        count_text(spheres.size() - shown, "sphere") + " more");
  }
  return text;
}

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

std::string plan_text(const PlanReport& report, const ViewOptions& /*options*/) {
  if (!report.plan) {
    return fmt::format(
        "{}: {}, {}\nno plan: a plan needs a camera, since only its rays share computations\n",
        report.path, count_text(report.scene.rays.size(), "given ray"),
        count_text(report.scene.spheres.size(), "sphere"));
  }
  const scene::Camera& camera = *report.scene.camera;
  const std::uint64_t all =
      static_cast<std::uint64_t>(camera.width) * static_cast<std::uint64_t>(camera.height);
  std::string text = fmt::format(
      "{}: {} x {} pixels, {}\n{}{}\nwanted: {}\n", scene_file_text(report.path, report.format),
      camera.width, camera.height, count_text(report.scene.spheres.size(), "sphere"),
      not_needed_text(report.not_needed), conventions_text(report.plan->conventions),
      scene::kWantedNames[static_cast<std::size_t>(report.plan->wanted)]);
  text += milliseconds(report.plan_ms) + " ms to plan, ";
  text += report.image_ms ? milliseconds(*report.image_ms) + " ms for the image on one core"
                          : "the image is not timed";
  if (report.image_ms && report.pixels_timed < all) {
    text += fmt::format(", estimated from {} pixels", report.pixels_timed);
  }
  text += "\n";
  if (report.interrupted) text += "INTERRUPTED: some items were not timed.\n";
  return text + "\n" + items_table(report) + spheres_table(report);
}

std::string plan_json(const PlanReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("plan");
  add_scene(json, report.path, report.scene);
  json["conventions"] = conventions_json(report.scene.conventions);
  json["dialect"] = text_or_null(report.format);
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
