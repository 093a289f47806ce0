#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "tools/gates/fingerprint.h"
#include "tools/gates/gate_views.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

std::string fingerprint_of(const Identity& one) {
  return fingerprint(
      fmt::format("{}\n{}\n{}\n{}\n{}", one.law, one.source, one.kind, one.place, one.candidate));
}

}  // namespace

std::string gitlab_codequality(const Gate& gate) {
  Json list = Json::array();
  for (const GateCheck& check : gate.checks) {
    if (check.outcome != GateOutcome::kFailed) continue;
    // GitLab wants a path: where no source is known, the candidate's name.
    const auto at = line_of(gate, check).value_or(properties::CodeLine{check.candidate});
    for (const Identity& one : check.defects) {
      if (is_known(one, gate.ratchet)) continue;
      list.push_back({{"description", fmt::format("{}: {} ({}, {}): {}", check.candidate, one.kind,
                                                  check.name, one.place, check.summary)},
                      {"check_name", fmt::format("raycheck/{}", one.law)},
                      {"fingerprint", fingerprint_of(one)},
                      {"severity", "major"},
                      {"location", {{"path", at.file}, {"lines", {{"begin", at.line}}}}}});
    }
  }
  return json_text(list);
}

}  // namespace raycheck::tools
