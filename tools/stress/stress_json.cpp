#include "tools/report/certificate.h"
#include "tools/report/json.h"
#include "tools/stress/stress.h"

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
    entry["severity"] = family.family->severities->meaning;
    entry["base"] = family.family->severities->base;
    entry["methods"] = Json::array();
    for (const StressCurve& curve : family.curves) {
      Json method;
      const scene::Precision precision = curve.candidate.precision;
      method["name"] = curve.candidate.name;
      method["isolated_by"] = text_or_null(curve.candidate.isolated_by);
      method["bounds_of"] = text_or_null(curve.candidate.bounds_of);
      method["precision"] = name(precision);
      method["stage"] = name(curve.stage);
      method["judged"] = curve.is_judged();
      method["first_failing"] = or_null(curve.first_failing());
      method["slope"] = or_null(curve.slope(family.family->severities->base));
      method["max_ratio"] = error_json(curve.worst_ratio());
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

std::string stress_certificates(const StressReport& report) {
  std::vector<Json> certificates;
  for (const FamilyReport& family : report.families) {
    for (const StressCurve& curve : family.curves) {
      const properties::Candidate candidate = curve.candidate.make();
      for (const properties::StressResult& result : curve.results) {
        for (const properties::Example& found : result.found) {
          const scene::Scene& scene = found.the_case.scene;
          certificates.push_back(certificate(scene, candidate.declared.over(scene.conventions),
                                             found.discrepancy, curve.candidate.name));
        }
      }
    }
  }
  return certificates_text(certificates);
}

}  // namespace raycheck::tools
