#include <nlohmann/json.hpp>

#include "properties/given_rays.h"
#include "properties/laws/law.h"
#include "tools/check/check_views.h"
#include "tools/report/certificate.h"

namespace raycheck::tools {
namespace {

using properties::Discrepancy;

/// What was asked about: the scene, or the ray that was given in a pixel's place.
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
  asked.scene =
      properties::given_rays({scene, {*place.pixel}}, candidate.conventions, candidate.precision)
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
