#include <nlohmann/json.hpp>

#include "tools/check/check_views.h"
#include "tools/report/certificate.h"

namespace raycheck::tools {

std::string check_certificates(const CheckReport& report) {
  std::vector<Json> certificates;
  for (const CandidateReport& candidate : report.candidates) {
    for (const auto& discrepancy : candidate.verdict.worst(report.top)) {
      certificates.push_back(
          certificate(report.scene, candidate.conventions, discrepancy, candidate.name));
    }
  }
  return certificates_text(certificates);
}

}  // namespace raycheck::tools
