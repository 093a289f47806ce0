#include <nlohmann/json.hpp>

#include "scene/number.h"
#include "tools/check/check_views.h"
#include "tools/gates/ratchet_json.h"
#include "tools/report/json.h"

namespace raycheck::tools {

namespace {

/// Null where every root >= 0 counts.
Json swallowed_json(const CandidateReport& candidate) {
  if (candidate.conventions.valid.is_usual()) return nullptr;
  const auto counts = [](const SwallowedOfSphere& one) {
    return Json{{"hits", one.hits}, {"swallowed", one.swallowed}, {"moved", one.moved}};
  };
  Json json = counts(candidate.swallowed.all());
  json["spheres"] = Json::array();
  for (const SwallowedOfSphere& one : candidate.swallowed.spheres) {
    json["spheres"].push_back(counts(one));
  }
  json["worst"] = Json::array();
  for (const SwallowedHit& hit : candidate.swallowed.worst) {
    Json entry = place_json(hit.place);
    entry["s"] = scene::hexfloat(hit.s);
    json["worst"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace

Json candidate_json(const CandidateReport& candidate, std::size_t top) {
  Json json;
  json["name"] = candidate.name;
  const Implementation& implementation = candidate.implementation;
  const auto& methods = implementation.methods;
  json["rays"] = methods ? Json(methods->rays->name) : Json(nullptr);
  json["intersect"] = methods ? Json(methods->intersect->name) : Json(nullptr);
  json["isolated_by"] = null_if_empty(implementation.isolated_by);
  json["bounds_of"] = null_if_empty(implementation.bounds_of);
  json["conventions"] = conventions_json(candidate.conventions);
  json["ns_per_ray"] = {{"make", error_json(candidate.timing.make)},
                        {"intersect", error_json(candidate.timing.intersect)}};
  json["quantities"] = tallies_json(candidate.verdict, candidate.precision);
  json["explanations"] = explanations_json(candidate.explanations);
  json["failures"] = {{"batches", candidate.search.batches},
                      {"found", candidate.search.found},
                      {"together", candidate.search.together},
                      {"most_sought", properties::kMostFailuresSought},
                      {"not_sought", candidate.search.not_sought}};
  json["given_rays"] = candidate.given_rays;
  json["precision"] = name(candidate.precision);
  json["swallowed"] = swallowed_json(candidate);
  json["rounded_numbers"] = candidate.rounded_numbers;
  json["not_asked"] = candidate.not_asked.empty() ? Json(nullptr) : Json(candidate.not_asked);
  json["discrepancies"] = candidate.verdict.discrepancies();
  json["discrepancies_by_standing"] = standings_json(candidate.verdict);
  json["inside_domain"] = candidate.inside_domain;
  const auto too_few = candidate.too_few_judged();
  json["too_few_judged"] =
      too_few ? Json{{"quantity", info(too_few->first).name}, {"question", name(too_few->second)}}
              : Json(nullptr);
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

std::string check_json(const CheckReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("check");
  json["scene"] = report.path;
  json["width"] = report.scene.camera ? Json(report.scene.camera->width) : Json(nullptr);
  json["height"] = report.scene.camera ? Json(report.scene.camera->height) : Json(nullptr);
  json["spheres"] = report.scene.spheres.size();
  json["conventions"] = conventions_json(report.scene.conventions);
  json["rays_in_scene"] = report.rays_in_scene;
  json["rays_judged"] = report.rays_judged;
  json["interrupted"] = report.interrupted;
  json["dialect"] = dialect_json(report.dialect);
  json["not_needed"] = report.not_needed;
  json["warnings"] = report.warnings;
  json["candidates"] = Json::array();
  for (const CandidateReport& candidate : report.candidates) {
    json["candidates"].push_back(candidate_json(candidate, report.top));
  }
  json["discrepancies"] = report.discrepancies();
  json["max_ulp"] = error_json(report.max_error);
  json["strict"] = report.strict;
  json["holds"] = report.holds();
  json["left_out"] = report.left_out;
  json["held_against"] = ratchet_json(report.ratchet);
  return json_text(json);
}

}  // namespace raycheck::tools
