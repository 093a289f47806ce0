#include <algorithm>

#include "tools/check/check.h"
#include "tools/report/format.h"

namespace raycheck::tools {
namespace {

using properties::Tally;
using properties::Wrong;

Json quantity_json(properties::Quantity quantity, const Tally& tally, double bound) {
  const auto count = [&](Wrong wrong) {
    const auto found = tally.wrong.find(wrong);
    return found == tally.wrong.end() ? std::uint64_t{0} : found->second;
  };
  const auto& place = tally.worst_place;
  const bool has_worst = tally.worst > 0 && has_place(quantity);
  Json json;
  json["name"] = info(quantity).name;
  json["unit"] = info(quantity).unit;
  json["cases"] = tally.cases;
  json["class_errors"] = tally.class_errors();
  json["missed"] = count(Wrong::kMissed);
  json["false_hits"] = count(Wrong::kFalseHit);
  json["wrong_sphere"] = count(Wrong::kWrongSphere);
  json["wrong_root"] = count(Wrong::kWrongRoot);
  json["class_errors_excused"] = tally.wrong_excused;
  json["ill_conditioned"] = tally.ill_conditioned;
  json["median_ulp"] = error_json(tally.median());
  json["max_ulp"] = error_json(tally.max());
  json["bound"] = tally.errors.empty() ? Json(nullptr) : error_json(bound);
  json["worst_pixel"] =
      has_worst && place.pixel ? Json{place.pixel->i, place.pixel->j} : Json(nullptr);
  json["worst_ray"] = has_worst ? Json(place.ray) : Json(nullptr);
  json["worst_sphere"] = has_worst && place.sphere ? Json(*place.sphere) : Json(nullptr);
  return json;
}

}  // namespace

Json candidate_json(const CandidateReport& candidate, std::size_t top) {
  Json json;
  json["name"] = candidate.name;
  const MethodPair* const methods = methods_of(candidate.contestant);
  json["rays"] = methods != nullptr ? Json(methods->rays->name) : Json(nullptr);
  json["intersect"] = methods != nullptr ? Json(methods->intersect->name) : Json(nullptr);
  const External* const external = external_of(candidate.contestant);
  json["isolated_by"] = external != nullptr ? Json(external->program.layers.text()) : Json(nullptr);
  json["conventions"] = conventions_json(candidate.conventions);
  json["ns_per_ray"] = {{"make", error_json(candidate.timing.make)},
                        {"intersect", error_json(candidate.timing.intersect)}};
  json["quantities"] = Json::array();
  for (const auto& [quantity, tally] : candidate.verdict.tallies()) {
    json["quantities"].push_back(
        quantity_json(quantity, tally, candidate.bounds[static_cast<std::size_t>(quantity)]));
  }
  json["explanations"] = Json::array();
  for (const properties::Explanation& one : candidate.explanations) {
    json["explanations"].push_back(
        {{"sentence", one.sentence}, {"wrong", one.errors}, {"explained", one.explained}});
  }
  json["discrepancies"] = candidate.verdict.discrepancies();
  json["discrepancies_excused"] = candidate.verdict.excused();
  json["worst"] = Json::array();
  for (const auto& discrepancy : candidate.verdict.worst(top)) {
    json["worst"].push_back(discrepancy_json(discrepancy));
  }
  json["left_out"] = Json::array();
  for (const LeftOut& entry : candidate.left_out) {
    json["left_out"].push_back({{"law", entry.law}, {"reason", entry.reason}});
  }
  return json;
}

std::string check_json(const CheckReport& report) {
  Json json = json_header("check");
  json["scene"] = report.path;
  json["width"] = report.scene.camera ? Json(report.scene.camera->width) : Json(nullptr);
  json["height"] = report.scene.camera ? Json(report.scene.camera->height) : Json(nullptr);
  json["spheres"] = report.scene.spheres.size();
  json["conventions"] = conventions_json(report.scene.conventions);
  json["rays_in_scene"] = report.rays_in_scene;
  json["rays_judged"] = report.rays_judged;
  json["interrupted"] = report.interrupted;
  json["warnings"] = report.warnings;
  json["candidates"] = Json::array();
  for (const CandidateReport& candidate : report.candidates) {
    json["candidates"].push_back(candidate_json(candidate, report.top));
  }
  json["discrepancies"] = report.discrepancies();
  json["left_out"] = report.left_out;
  return json.dump(2) + "\n";
}

}  // namespace raycheck::tools
