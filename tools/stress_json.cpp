#include "tools/format.h"
#include "tools/stress.h"

namespace raycheck::tools {
namespace {

using properties::Tally;
using properties::Verdict;

Json tally_json(const Tally& tally, std::string_view unit) {
  Json json;
  json["cases"] = tally.cases;
  for (const auto& [wrong, number] : tally.wrong) json["wrong"][std::string(name(wrong))] = number;
  json["wrong_excused"] = tally.wrong_excused;
  if (!tally.errors.empty()) {
    json["unit"] = unit;
    json["median"] = error_json(tally.median());
    json["p999"] = error_json(tally.quantile(0.999));
    json["max"] = error_json(tally.max());
    json["max_ratio"] =
        error_json(tally.worst_ratio < 0 ? std::nullopt : std::optional(tally.worst_ratio));
    json["median_condition"] = error_json(tally.condition_quantile(0.5));
  }
  for (std::size_t k = 0; k < properties::kOutcomeCount; ++k) {
    json["outcomes"][std::string(properties::kOutcomeNames[k])] = tally.outcomes[k];
  }
  return json;
}

Json verdict_json(const Verdict& verdict) {
  Json json = Json::object();
  for (const auto& [quantity, tally] : verdict.tallies()) {
    json[std::string(info(quantity).name)] = tally_json(tally, info(quantity).unit);
  }
  return json;
}

}  // namespace

std::string stress_json(const StressReport& report) {
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
      method["name"] = curve.method.name();
      method["stage"] = name(curve.method.stage);
      method["judged"] = curve.is_judged();
      const std::optional<int> failing = curve.first_failing();
      method["first_failing"] = failing ? Json(*failing) : Json(nullptr);
      const std::optional<double> slope = curve.slope(family.family->dial->base);
      method["slope"] = slope ? Json(*slope) : Json(nullptr);
      method["max_ratio"] =
          error_json(curve.worst_ratio() < 0 ? std::nullopt : std::optional(curve.worst_ratio()));
      for (std::size_t k = 0; k < curve.results.size(); ++k) {
        method["severities"].push_back({{"severity", curve.first + static_cast<int>(k)},
                                        {"inside", verdict_json(curve.results[k].inside)},
                                        {"outside", verdict_json(curve.results[k].outside)}});
      }
      entry["methods"].push_back(std::move(method));
    }
    json["families"].push_back(std::move(entry));
  }
  return json.dump(2) + "\n";
}

}  // namespace raycheck::tools
