#include "tools/gates/gate.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// Numbers the names that a candidate has twice.
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
  return static_cast<std::uint64_t>(std::ranges::count(checks, outcome, &GateCheck::outcome));
}

bool is_known(const Identity& one, const std::optional<Ratchet>& ratchet) {
  return ratchet && std::ranges::binary_search(ratchet->known, one);
}

std::optional<properties::CodeLine> line_of(const Gate& gate, const GateCheck& check) {
  if (check.line) return check.line;
  const auto source = gate.sources.find(check.candidate);
  if (source == gate.sources.end()) return std::nullopt;
  return properties::CodeLine{source->second};
}

GateCheck& add_check(Gate& gate, GateCheck check, const LeftUndecided& undecided) {
  const bool has_found = !check.defects.empty() || !undecided.kept.empty();
  check.outcome = has_found ? GateOutcome::kKnown : GateOutcome::kPassed;
  const auto are_known = [&](const std::vector<Identity>& found) {
    gate.findings.found.insert(found.begin(), found.end());
    return std::ranges::all_of(found,
                               [&](const Identity& one) { return is_known(one, gate.ratchet); });
  };
  gate.findings.is_cut = gate.findings.is_cut || undecided.is_cut;
  if (!are_known(undecided.kept) || undecided.is_cut) check.outcome = GateOutcome::kInconclusive;
  if (!are_known(check.defects)) check.outcome = GateOutcome::kFailed;
  const bool is_about_undecided =
      check.outcome == GateOutcome::kInconclusive || check.defects.empty();
  if (undecided.answers > 0 && is_about_undecided) {
    check.summary = fmt::format("{} undecided", count_text(undecided.answers, "answer"));
  }
  return gate.checks.emplace_back(std::move(check));
}

void complete(Gate& gate, bool was_interrupted) {
  const auto add = [&](const char* name, const char* summary) {
    gate.checks.push_back({"raycheck", name, GateOutcome::kInconclusive, summary, {}, {}});
  };
  // An inconclusive check already contains its reason.
  const bool is_empty = gate.count(GateOutcome::kLeftOut) == gate.checks.size();
  if (was_interrupted) add("finished", "interrupted before everything was judged");
  if (is_empty) add("judged", "nothing was judged");
  make_unique(gate.checks);
}

std::map<std::string, std::array<std::size_t, kGateOutcomes>> outcomes_by_candidate(
    const Gate& gate) {
  std::map<std::string, std::array<std::size_t, kGateOutcomes>> counts;
  for (const GateCheck& check : gate.checks) {
    ++counts[check.candidate][static_cast<std::size_t>(check.outcome)];
  }
  return counts;
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

namespace {

Json identities_json(const std::vector<Identity>& identities) {
  return list_json(identities, [](const Identity& one) {
    return Json{{"law", one.law},
                {"source", one.source},
                {"kind", one.kind},
                {"place", one.place},
                {"candidate", one.candidate}};
  });
}

}  // namespace

Json ratchet_json(const std::optional<Ratchet>& ratchet) {
  if (!ratchet) return nullptr;
  return {{"file", ratchet->file},
          {"known", identities_json(ratchet->known)},
          {"new", identities_json(ratchet->added)},
          {"mended", identities_json(ratchet->mended)},
          {"not_asked", identities_json(ratchet->unasked)},
          {"strict", ratchet->strict},
          {"fails", ratchet->fails()}};
}

}  // namespace raycheck::tools
