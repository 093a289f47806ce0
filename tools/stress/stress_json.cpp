#include <nlohmann/json.hpp>

#include "tools/report/json.h"
#include "tools/stress/stress_views.h"

namespace raycheck::tools {
std::string stress_json(const StressReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("stress");
  json["interrupted"] = report.interrupted;
  json["cases"] = report.cases;
  json["seed"] = report.seed;
  json["stable_ratio"] = properties::kStableRatio;
  json["families"] = Json::array();
  for (const FamilyReport& family : report.families) {
    Json entry;
    entry["name"] = family.family->name;
    entry["severity"] = family.family->dial->meaning;
    entry["base"] = family.family->dial->base;
    entry["methods"] = Json::array();
    for (const StressCurve& curve : family.curves) {
      Json method;
      const scene::Precision precision = curve.method.precision;
      method["name"] = curve.method.name;
      method["isolated_by"] = null_if_empty(curve.method.isolated_by);
      method["bounds_of"] = null_if_empty(curve.method.bounds_of);
      method["precision"] = name(precision);
      method["stage"] = name(curve.stage);
      method["judged"] = curve.is_judged();
      const std::optional<int> failing = curve.first_failing();
      method["first_failing"] = failing ? Json(*failing) : Json(nullptr);
      const std::optional<double> slope = curve.slope(family.family->dial->base);
      method["slope"] = slope ? Json(*slope) : Json(nullptr);
      method["max_ratio"] =
          error_json(curve.worst_ratio() < 0 ? std::nullopt : std::optional(curve.worst_ratio()));
      for (std::size_t k = 0; k < curve.results.size(); ++k) {
        method["severities"].push_back(
            {{"severity", curve.severities[k]},
             {"left_out", curve.results[k].left_out},
             {"inside", tallies_json(curve.results[k].inside, precision)},
             {"outside", tallies_json(curve.results[k].outside, precision)}});
      }
      entry["methods"].push_back(std::move(method));
    }
    json["families"].push_back(std::move(entry));
  }
  return json_text(json);
}

}  // namespace raycheck::tools
