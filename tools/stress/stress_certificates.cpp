#include <nlohmann/json.hpp>

#include "tools/report/certificate.h"
#include "tools/stress/stress_views.h"

namespace raycheck::tools {

std::string stress_certificates(const StressReport& report) {
  std::vector<Json> certificates;
  for (const FamilyReport& family : report.families) {
    for (const StressCurve& curve : family.curves) {
      const properties::Candidate candidate = curve.method.make();
      for (const properties::StressResult& result : curve.results) {
        for (const properties::Example& found : result.found) {
          const scene::Scene& scene = found.the_case.scene;
          certificates.push_back(certificate(scene, candidate.declared.over(scene.conventions),
                                             found.discrepancy, curve.method.name));
        }
      }
    }
  }
  return certificates_text(certificates);
}

}  // namespace raycheck::tools
