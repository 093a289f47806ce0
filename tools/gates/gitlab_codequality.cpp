#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "tools/gates/gate_views.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

/// A hash of a text, the same on every machine: 32 hexadecimal digits by which readers recognise a
/// finding. Collisions are improbable, but not secure against those who construct them.
/// FNV-1a, twice with different offsets, for 128 bits. Source: Fowler, Noll, Vo.
std::string fingerprint(std::string_view text) {
  constexpr std::uint64_t kPrime = 0x100000001B3;
  const auto hash = [&](std::uint64_t value) {
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * kPrime;
    return value;
  };
  return fmt::format("{:016x}{:016x}", hash(0xCBF29CE484222325), hash(0x84222325CBF29CE4));
}

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
