#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "properties/laws/law.h"
#include "tools/check/check.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

using properties::Discrepancy;
using properties::Quantity;
using properties::Standing;
using properties::Tally;

std::string place_of(const Discrepancy& discrepancy) {
  if (!has_place(discrepancy.quantity)) return "scene";
  return discrepancy.place.sphere ? fmt::format("sphere {}", *discrepancy.place.sphere) : "ray";
}

Identity identity_of(const Discrepancy& discrepancy, const CheckReport& report,
                     const CandidateReport& candidate) {
  const properties::DefectKind kind = {discrepancy.quantity, discrepancy.wrong};
  const bool is_held = properties::is_held_against(discrepancy, report.strict);
  return {std::string(discrepancy.law), lasting_path(report.path),
          is_held ? kind_text(kind) : undecided_text(kind), place_of(discrepancy),
          candidate.lasting_name};
}

/// The defects of a candidate, the worst first, or its undecided discrepancies.
std::vector<Discrepancy> found_of(const CheckReport& report, const CandidateReport& candidate,
                                  bool is_held) {
  std::vector<Discrepancy> found = candidate.verdict.worst(properties::kKeptDiscrepancies);
  std::erase_if(found, [&](const Discrepancy& one) {
    const bool held = properties::is_held_against(one, report.strict);
    return is_held != held || !(held || one.excuse.standing() == Standing::kUndecided);
  });
  return found;
}

std::string text_of(const CheckReport& report, const CandidateReport& candidate,
                    const std::vector<Discrepancy>& defects) {
  const bool draws = candidate.implementation.draws();
  std::string text = explanations_text(candidate.explanations, draws ? "pixels" : "answers");
  for (std::size_t k = 0; k < std::min(defects.size(), report.top); ++k) {
    text += fmt::format("{}. {}", k + 1, discrepancy_text(defects[k], false));
  }
  return text;
}

void add_check_of(Quantity quantity, const Tally& tally, Gate& gate, const CheckReport& report,
                  const CandidateReport& candidate) {
  const auto of_quantity = [&](bool is_held) {
    std::vector<Discrepancy> found = found_of(report, candidate, is_held);
    std::erase_if(found, [&](const Discrepancy& one) { return one.quantity != quantity; });
    return found;
  };
  const auto identities = [&](const std::vector<Discrepancy>& found) {
    std::set<Identity> all;
    for (const Discrepancy& one : found) all.insert(identity_of(one, report, candidate));
    return std::vector<Identity>(all.begin(), all.end());
  };
  const std::vector<Discrepancy> defects = of_quantity(true), undecided = of_quantity(false);
  const std::uint64_t answers = report.strict ? 0 : tally.count(Standing::kUndecided);
  GateCheck& check = add_check(gate,
                               {.candidate = candidate.name,
                                .name = fmt::format("{}/{}", info(quantity).name, report.path),
                                .defects = identities(defects)},
                               {answers, identities(undecided), undecided.size() < answers});
  for (const Discrepancy& one : defects) {
    if (!check.line) check.line = one.failed.line;
  }
  if (!check.summary.empty()) return;
  if (!defects.empty()) {
    const auto& why = candidate.explanations;
    check.summary = fmt::format("{}{} at {}", why.empty() ? "" : why.front().sentence + ": ",
                                check.defects.front().kind, place_text(defects.front().place));
    check.text = text_of(report, candidate, defects);
  } else if (tally.cases == 0) {
    check.outcome = GateOutcome::kLeftOut;
    check.summary = "there was nothing to compare";
  }
}

void add_checks(Gate& gate, const CheckReport& report, const CandidateReport& candidate) {
  if (const std::string& file = candidate.implementation.source_file; !file.empty()) {
    gate.sources.emplace(candidate.name, file);
  }
  for (const auto& [quantity, tally] : candidate.verdict.tallies()) {
    add_check_of(quantity, tally, gate, report, candidate);
  }
  const std::string too_few = too_few_text(candidate);
  if (!too_few.empty()) {
    gate.checks.push_back({candidate.name, "judged", GateOutcome::kInconclusive, too_few});
  }
  for (const LeftOut& one : candidate.left_out) {
    gate.checks.push_back({candidate.name, fmt::format("{}/{}", one.law, report.path),
                           GateOutcome::kLeftOut, one.reason});
  }
  // Only the worst kKeptDiscrepancies are kept: if there are more, a baseline entry that is not
  // found here may still occur.
  const bool has_all = candidate.verdict.discrepancies() < properties::kKeptDiscrepancies;
  if (report.interrupted || !has_all || !candidate.is_judged()) return;
  for (const properties::Law& law : properties::laws()) {
    gate.findings.asked.insert(
        {std::string(law.name), lasting_path(report.path), candidate.lasting_name});
  }
}

}  // namespace

Gate check_gate(const CheckReport& report) {
  Gate gate;
  gate.command = "check";
  gate.about = fmt::format("{}, {} of {} judged", report.path, report.rays_judged,
                           count_text(report.rays_in_scene, "ray"));
  gate.ratchet = report.ratchet;
  for (const CandidateReport& candidate : report.candidates) add_checks(gate, report, candidate);
  gate.findings.complete = gate.findings.asked;
  complete(gate, report.interrupted);
  return gate;
}

}  // namespace raycheck::tools
