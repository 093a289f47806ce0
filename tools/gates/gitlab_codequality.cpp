#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "tools/gates/gate_views.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

/// Of an identity, the same on every machine: FNV-1a, twice with different beginnings, for 128
/// bits. Source: Fowler, Noll, Vo.
std::string fingerprint(const Identity& one) {
  const std::string text =
      fmt::format("{}\n{}\n{}\n{}\n{}", one.law, one.source, one.kind, one.place, one.candidate);
  constexpr std::uint64_t kPrime = 0x100000001B3;
  const auto hash = [&](std::uint64_t value) {
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * kPrime;
    return value;
  };
  return fmt::format("{:016x}{:016x}", hash(0xCBF29CE484222325), hash(0x84222325CBF29CE4));
}

/// Where GitLab is to show it: the candidate's file, else what it is called.
std::string path_of(const Gate& gate, const Identity& one) {
  for (const SourceFile& source : gate.sources) {
    if (source.candidate == one.candidate) return source.path;
  }
  return one.candidate;
}

}  // namespace

std::string gitlab_codequality(const Gate& gate) {
  Json list = Json::array();
  for (const GateCheck& check : gate.checks) {
    if (check.outcome != GateOutcome::kFailed) continue;
    for (const Identity& one : check.defects) {
      const bool is_known = gate.ratchet && std::binary_search(gate.ratchet->known.begin(),
                                                               gate.ratchet->known.end(), one);
      if (is_known) continue;
      list.push_back({{"description", fmt::format("{}: {} ({}, {}): {}", one.candidate, one.kind,
                                                  check.name, one.place, check.summary)},
                      {"check_name", fmt::format("raycheck/{}", one.law)},
                      {"fingerprint", fingerprint(one)},
                      {"severity", "major"},
                      {"location", {{"path", path_of(gate, one)}, {"lines", {{"begin", 1}}}}}});
    }
  }
  return json_text(list);
}

}  // namespace raycheck::tools
