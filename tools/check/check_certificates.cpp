#include <nlohmann/json.hpp>

#include "properties/given_rays.h"
#include "properties/laws/law.h"
#include "tools/check/check_views.h"
#include "tools/report/certificate.h"

namespace raycheck::tools {
namespace {

using properties::Discrepancy;

/// What was asked about: the scene, or the ray that was given in a pixel's place.
struct Subject {
  scene::Scene scene;
  Discrepancy discrepancy;
};

Subject subject_of(const CheckReport& report, const CandidateReport& candidate,
                   const Discrepancy& discrepancy) {
  const scene::Scene& scene = report.scene_of(candidate);
  Subject subject{scene, discrepancy};
  const properties::Law& law = *properties::find_law(discrepancy.law);
  properties::Place& place = subject.discrepancy.place;
  if (!candidate.given_rays || !place.pixel || !needs_any(law.needs, properties::Needs::kRays)) {
    return subject;
  }
  subject.scene =
      properties::given_rays({scene, {*place.pixel}}, candidate.conventions, candidate.precision)
          .value()
          .the_case.scene;
  place.ray = 0;
  place.pixel.reset();
  return subject;
}

}  // namespace

std::string check_certificates(const CheckReport& report) {
  std::vector<Json> certificates;
  for (const CandidateReport& candidate : report.candidates) {
    for (const auto& discrepancy : candidate.verdict.worst(report.top)) {
      const Subject subject = subject_of(report, candidate, discrepancy);
      certificates.push_back(
          certificate(subject.scene, candidate.conventions, subject.discrepancy, candidate.name));
    }
  }
  return certificates_text(certificates);
}

}  // namespace raycheck::tools
