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

/// Where GitLab is to show it: the candidate's file, else what it is called.
std::string path_of(const Gate& gate, const std::string& candidate) {
  for (const SourceFile& source : gate.sources) {
    if (source.candidate == candidate) return source.path;
  }
  return candidate;
}

}  // namespace

std::string gitlab_codequality(const Gate& gate) {
  Json list = Json::array();
  for (const GateCheck& check : gate.checks) {
    if (check.outcome != GateOutcome::kFailed) continue;
    for (const Identity& one : check.defects) {
      if (is_known(one, gate.ratchet)) continue;
      list.push_back(
          {{"description", fmt::format("{}: {} ({}, {}): {}", check.candidate, one.kind, check.name,
                                       one.place, check.summary)},
           {"check_name", fmt::format("raycheck/{}", one.law)},
           {"fingerprint", fingerprint_of(one)},
           {"severity", "major"},
           {"location", {{"path", path_of(gate, check.candidate)}, {"lines", {{"begin", 1}}}}}});
    }
  }
  return json_text(list);
}

}  // namespace raycheck::tools
