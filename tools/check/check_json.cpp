#include "properties/laws/law.h"
#include "scene/number.h"
#include "tools/check/check.h"
#include "tools/report/certificate.h"
#include "tools/report/json.h"

namespace raycheck::tools {

namespace {

/// The hits that an interval or culling excludes; null if every root >= 0 counts.
Json excluded_json(const CandidateReport& candidate) {
  if (candidate.conventions.valid.is_usual()) return nullptr;
  const auto counts = [](const ExcludedOfSphere& one) {
    return Json{{"hits", one.hits}, {"excluded", one.excluded}, {"moved", one.moved}};
  };
  Json json = counts(candidate.excluded.all());
  json["spheres"] = list_json(candidate.excluded.spheres, counts);
  json["worst"] = list_json(candidate.excluded.worst, [](const ExcludedHit& hit) {
    Json entry = place_json(hit.place);
    entry["s"] = scene::hexfloat(hit.s);
    return entry;
  });
  return json;
}

Json candidate_json(const CandidateReport& candidate, std::size_t top) {
  Json json;
  json["name"] = candidate.name;
  const Implementation& implementation = candidate.implementation;
  const auto& methods = implementation.methods;
  json["rays"] = methods ? Json(methods->rays->name) : Json(nullptr);
  json["intersect"] = methods ? Json(methods->intersect->name) : Json(nullptr);
  json["isolated_by"] = text_or_null(implementation.isolated_by);
  json["bounds_of"] = text_or_null(implementation.bounds_of);
  json["conventions"] = conventions_json(candidate.conventions);
  json["quantities"] = tallies_json(candidate.verdict, candidate.precision);
  json["explanations"] = explanations_json(candidate.explanations);
  json["failures"] = {{"batches", candidate.search.batches},
                      {"found", candidate.search.found},
                      {"together", candidate.search.together},
                      {"most_sought", properties::kMostFailuresSought},
                      {"not_sought", candidate.search.not_sought}};
  json["given_rays"] = candidate.given_rays;
  json["precision"] = name(candidate.precision);
  json["excluded"] = excluded_json(candidate);
  json["rounded_numbers"] = candidate.rounded_numbers;
  json["made_unit"] = candidate.made_unit;
  json["not_asked"] = text_or_null(candidate.not_asked);
  json["discrepancies"] = candidate.verdict.discrepancies();
  json["discrepancies_by_standing"] = standings_json(candidate.verdict);
  json["tolerated"] = candidate.verdict.tolerated();
  json["inside_domain"] = candidate.inside_domain;
  json["too_few_judged"] = or_null(candidate.too_few_judged(), too_few_json);
  json["worst"] = list_json(candidate.verdict.worst(top), discrepancy_json);
  json["left_out"] = list_json(candidate.left_out, [](const LeftOut& entry) {
    return Json{{"law", entry.law}, {"reason", entry.reason}};
  });
  return json;
}

}  // namespace

std::string check_json(const CheckReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("check");
  add_scene(json, report.path, report.scene);
  json["spheres"] = report.scene.spheres.size();
  json["conventions"] = conventions_json(report.scene.conventions);
  json["rays_in_scene"] = report.rays_in_scene;
  json["rays_judged"] = report.rays_judged;
  json["interrupted"] = report.interrupted;
  json["dialect"] = text_or_null(report.format);
  json["not_needed"] = report.not_needed;
  json["warnings"] = report.warnings;
  json["candidates"] = list_json(report.candidates, [&](const CandidateReport& candidate) {
    return candidate_json(candidate, report.top);
  });
  json["discrepancies"] = report.discrepancies();
  json["max_ulp"] = error_json(report.max_error);
  json["strict"] = report.strict;
  json["holds"] = report.holds();
  json["left_out"] = left_out_lines(report);
  json["held_against"] = ratchet_json(report.ratchet);
  return json_text(json);
}

namespace {

using properties::Discrepancy;

/// What a question was about: the scene, or the ray that the candidate got instead of a pixel.
struct Asked {
  scene::Scene scene;
  Discrepancy discrepancy;
};

Asked asked_of(const CheckReport& report, const CandidateReport& candidate,
               const Discrepancy& discrepancy) {
  const scene::Scene& scene = report.scene_of(candidate);
  Asked asked{scene, discrepancy};
  const properties::Law& law = *properties::find_law(discrepancy.law);
  properties::Place& place = asked.discrepancy.place;
  if (!candidate.given_rays || !place.pixel || !needs_any(law.needs, properties::Needs::kRays)) {
    return asked;
  }
  asked.scene = properties::given_rays({scene, {*place.pixel}}, candidate.conventions,
                                       candidate.implementation.input_format())
                    .value()
                    .the_case.scene;
  place.ray = 0;
  place.pixel.reset();
  return asked;
}

}  // namespace

std::string check_certificates(const CheckReport& report) {
  std::vector<Json> certificates;
  for (const CandidateReport& candidate : report.candidates) {
    for (const auto& discrepancy : candidate.verdict.worst(report.top)) {
      const Asked asked = asked_of(report, candidate, discrepancy);
      certificates.push_back(
          certificate(asked.scene, candidate.conventions, asked.discrepancy, candidate.name));
    }
  }
  return certificates_text(certificates);
}

}  // namespace raycheck::tools
