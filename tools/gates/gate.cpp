#include "tools/gates/gate.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

namespace raycheck::tools {
namespace {

/// Names that a candidate has twice are numbered.
void make_unique(std::vector<GateCheck>& checks) {
  std::set<std::pair<std::string, std::string>> taken;
  for (GateCheck& check : checks) {
    const std::string once = check.name;
    for (int k = 2; !taken.emplace(check.candidate, check.name).second; ++k) {
      check.name = fmt::format("{} ({})", once, k);
    }
  }
}

}  // namespace

std::uint64_t Gate::count(GateOutcome outcome) const {
  return static_cast<std::uint64_t>(
      std::count_if(checks.begin(), checks.end(),
                    [&](const GateCheck& check) { return check.outcome == outcome; }));
}

bool is_known(const Identity& one, const std::optional<Ratchet>& ratchet) {
  return ratchet && std::binary_search(ratchet->known.begin(), ratchet->known.end(), one);
}

std::optional<properties::CodeLine> line_of(const Gate& gate, const GateCheck& check) {
  if (check.line) return check.line;
  for (const SourceFile& source : gate.sources) {
    if (source.candidate == check.candidate) return properties::CodeLine{source.path};
  }
  return std::nullopt;
}

GateOutcome outcome_of(const std::vector<Identity>& found, const std::optional<Ratchet>& ratchet) {
  GateOutcome outcome = found.empty() ? GateOutcome::kPassed : GateOutcome::kKnown;
  for (const Identity& one : found) {
    if (is_known(one, ratchet)) continue;
    if (!one.is_undecided()) return GateOutcome::kFailed;
    outcome = GateOutcome::kInconclusive;
  }
  return outcome;
}

void complete(Gate& gate, bool was_interrupted) {
  const auto add = [&](const char* name, const char* summary) {
    gate.checks.push_back({"raycheck", name, GateOutcome::kInconclusive, summary, {}, {}});
  };
  // Where a check is inconclusive, it says why.
  const bool is_empty = gate.count(GateOutcome::kLeftOut) == gate.checks.size();
  if (was_interrupted) add("finished", "interrupted: not all was judged");
  if (is_empty) add("judged", "nothing was judged");
  make_unique(gate.checks);
}

std::string outcomes_text(const Gate& gate) {
  std::string text;
  for (std::size_t k = 0; k < kGateOutcomes; ++k) {
    const auto outcome = static_cast<GateOutcome>(k);
    const std::uint64_t count = gate.count(outcome);
    if (count == 0 && outcome != GateOutcome::kFailed) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name(outcome));
  }
  return text;
}

}  // namespace raycheck::tools
