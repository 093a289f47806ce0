#include <fmt/core.h>

#include <array>

#include "properties/cases/case_text.h"
#include "tools/report/json.h"
#include "tools/report/words.h"
#include "tools/view/scene_view.h"
#include "tools/worst/worst.h"

namespace raycheck::tools {
namespace {

std::string headline(const WorstReport& report) {
  const properties::WorstCase& worst = *report.worst;
  return fmt::format("{} {} on {}: off by {} {}, condition number {}, rho {}: {}",
                     report.candidate.name, info(report.search.quantity).name,
                     report.source().name(), error_text(worst.error),
                     unit_name(report.search.quantity, report.candidate.precision),
                     error_text(worst.stability.condition), error_text(worst.stability.ratio),
                     name(worst.stability.outcome));
}

std::string failures_text(const WorstReport& report) {
  if (report.failures == 0) return "";
  return fmt::format("failed {}, first: {}\n",
                     report.failures == 1 ? "once" : fmt::format("{} times", report.failures),
                     report.first_failure);
}

}  // namespace

std::string worst_text(const WorstReport& report, const ViewOptions& /*options*/) {
  const std::string others = isolation_text({report.candidate}) + failures_text(report);
  if (!report.worst) {
    return others + fmt::format(
                        "{} on {}: nothing was measured: each case lies outside the judged domain, "
                        "or its answer failed, is a wrong decision, or is not finite\n",
                        report.candidate.name, report.source().name());
  }
  const properties::WorstCase& worst = *report.worst;
  std::string text = others + headline(report) + "\n";
  constexpr std::array<std::string_view, 3> kMeasures = {"error", "error / growth of the bound",
                                                         "stability ratio rho"};
  text += report.stage == properties::Stage::kRays
              ? fmt::format(
                    "only the {} is measured; `raycheck properties` also judges other quantities\n",
                    info(report.search.quantity).name)
              : "only errors of right decisions are measured; `raycheck properties` also judges "
                "decisions\n";
  text += fmt::format(
      "rho = error / ((1 + condition number) u), with k u for an error of k ulp; at most {:g} is "
      "stable\n"
      "largest {}: {} among random cases, {} after climbing from the worst of them; the case below "
      "is simplified and has {}\n",
      properties::kStableRatio, kMeasures[static_cast<std::size_t>(report.search.climb)],
      error_text(worst.height_random), error_text(worst.height_climbed), error_text(worst.height));
  text += fmt::format("  got   {}\n  exact {}\n\n", got_text(worst.shown), exact_text(worst.shown));
  return text + properties::scene_text(worst.the_case);
}

std::string worst_scene(const WorstReport& report) {
  return properties::scene_text(report.worst->the_case, headline(report));
}

std::string worst_json(const WorstReport& report, const ViewOptions& /*options*/) {
  const properties::SearchOptions& search = report.search;
  Json json = json_header("worst");
  json["method"] = report.candidate.name;
  json["isolated_by"] = text_or_null(report.candidate.isolated_by);
  json["bounds_of"] = text_or_null(report.candidate.bounds_of);
  json["family"] = report.source().name();
  json["seed"] = search.seed;
  json["searches"] = report.searches;
  json["climbed_on"] = properties::kClimbNames[static_cast<std::size_t>(search.climb)];
  json["precision"] = name(report.candidate.precision);
  json["unit"] = unit_name(search.quantity, report.candidate.precision);
  json["measured"] = report.worst.has_value();
  json["failures"] = {{"count", report.failures}, {"first", report.first_failure}};
  json["interrupted"] = report.interrupted;
  if (!report.worst) return json_text(json);
  const properties::WorstCase& worst = *report.worst;
  json["random"] = error_json(worst.height_random);
  json["climbed"] = error_json(worst.height_climbed);
  json["shrunk"] = error_json(worst.height);
  json["error"] = error_json(worst.error);
  json["condition"] = error_json(worst.stability.condition);
  json["ratio"] = error_json(worst.stability.ratio);
  json["outcome"] = name(worst.stability.outcome);
  json["discrepancy"] = discrepancy_json(worst.shown);
  json["scene"] = properties::scene_text(worst.the_case);
  return json_text(json);
}

ViewDocument worst_document(const WorstReport& report, const properties::RunControl& control) {
  const properties::WorstCase& worst = *report.worst;
  ViewDocument document;
  document.title =
      fmt::format("worst case of {} on {}", report.candidate.name, report.source().name());
  SceneViewOptions view;
  view.name = "worst.toml";
  view.file = view.name;
  show(report.candidate, view);
  view.wanted = selections_of(worst.the_case, worst.shown.place);
  document.scenes.push_back(view_of(worst.the_case.scene, view, document.left_out, control));
  document.findings.push_back({discrepancy_head(worst.shown), report.candidate.name,
                               report.candidate.name, worst.shown.excuse.standing(), 0,
                               selection_of(worst.shown.place, worst.the_case.scene)});
  document.found = "1";
  return document;
}

}  // namespace raycheck::tools
