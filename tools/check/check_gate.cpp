#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "properties/laws/law.h"
#include "tools/check/check_views.h"
#include "tools/gates/gate_views.h"
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

/// What is held against a candidate, the worst first; or what is left undecided beside.
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

GateCheck check_of(Quantity quantity, const Tally& tally, const CheckReport& report,
                   const CandidateReport& candidate) {
  const auto of_quantity = [&](bool is_held) {
    std::vector<Discrepancy> found = found_of(report, candidate, is_held);
    std::erase_if(found, [&](const Discrepancy& one) { return one.quantity != quantity; });
    return found;
  };
  const std::vector<Discrepancy> defects = of_quantity(true), undecided = of_quantity(false);
  GateCheck check;
  check.candidate = candidate.name;
  check.name = fmt::format("{}/{}", info(quantity).name, report.path);
  std::set<Identity> identities;
  for (const Discrepancy& one : defects) identities.insert(identity_of(one, report, candidate));
  check.defects = {identities.begin(), identities.end()};
  for (const Discrepancy& one : defects) {
    if (one.wrong != properties::Wrong::kFailed) continue;
    check.failed.push_back(
        {identity_of(one, report, candidate), discrepancy_text(one, false), one.failed.line});
  }
  for (const Discrepancy& one : undecided) identities.insert(identity_of(one, report, candidate));
  check.outcome = outcome_of({identities.begin(), identities.end()}, report.ratchet);
  const std::uint64_t all_undecided = report.strict ? 0 : tally.count(Standing::kUndecided);
  // What is not kept no baseline knows.
  const bool is_cut = undecided.size() < all_undecided;
  if (is_cut && check.outcome != GateOutcome::kFailed) check.outcome = GateOutcome::kInconclusive;
  const bool is_about_undecided = check.outcome == GateOutcome::kInconclusive || defects.empty();
  if (all_undecided > 0 && is_about_undecided) {
    check.summary = count_text(all_undecided, "answer") + " undecided";
  } else if (!defects.empty()) {
    const auto& why = candidate.explanations;
    check.summary = fmt::format("{}{} at {}", why.empty() ? "" : why.front().sentence + ": ",
                                check.defects.front().kind, place_text(defects.front().place));
    check.text = text_of(report, candidate, defects);
  } else if (tally.cases == 0) {
    check.outcome = GateOutcome::kLeftOut;
    check.summary = "nothing to compare";
  }
  return check;
}

void add_checks(Gate& gate, const CheckReport& report, const CandidateReport& candidate) {
  if (const std::string& file = candidate.implementation.source_file; !file.empty()) {
    gate.sources.push_back({candidate.name, file});
  }
  for (const auto& [quantity, tally] : candidate.verdict.tallies()) {
    gate.checks.push_back(check_of(quantity, tally, report, candidate));
  }
  const std::string too_few = too_few_text(candidate);
  if (!too_few.empty()) {
    gate.checks.push_back({candidate.name, "judged", GateOutcome::kInconclusive, too_few, {}, {}});
  }
  for (const LeftOut& one : candidate.left_out) {
    gate.checks.push_back({candidate.name,
                           fmt::format("{}/{}", one.law, report.path),
                           GateOutcome::kLeftOut,
                           one.reason,
                           {},
                           {}});
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
  complete(gate, report.interrupted);
  return gate;
}

Findings findings_of(const CheckReport& report) {
  Findings findings;
  for (const CandidateReport& candidate : report.candidates) {
    const auto defects = found_of(report, candidate, true),
               undecided = found_of(report, candidate, false);
    for (const auto* const found : {&defects, &undecided}) {
      for (const Discrepancy& one : *found) {
        findings.found.insert(identity_of(one, report, candidate));
      }
    }
    const std::uint64_t all = candidate.verdict.count(Standing::kUndecided);
    findings.is_cut = findings.is_cut || (!report.strict && undecided.size() < all);
    // Of more discrepancies than are kept, those that are not there may have been dropped.
    const bool has_all = candidate.verdict.discrepancies() < properties::kKeptDiscrepancies;
    if (report.interrupted || !has_all || !candidate.is_judged()) continue;
    for (const properties::Law& law : properties::laws()) {
      findings.asked.insert(
          {std::string(law.name), lasting_path(report.path), candidate.lasting_name});
    }
  }
  findings.complete = findings.asked;
  return findings;
}

std::string check_junit(const CheckReport& report, const ViewOptions& /*options*/) {
  return junit(check_gate(report));
}
std::string check_markdown(const CheckReport& report, const ViewOptions& options) {
  Gate gate = check_gate(report);
  if (options.picture_link.empty() && report.scene.camera && !report.holds()) {
    gate.picture = check_picture(report, options);
  }
  return markdown(gate, options.picture_link);
}
std::string check_github(const CheckReport& report, const ViewOptions& /*options*/) {
  return github(check_gate(report));
}
std::string check_sarif(const CheckReport& report, const ViewOptions& /*options*/) {
  return sarif(check_gate(report));
}
std::string check_gitlab_codequality(const CheckReport& report, const ViewOptions& /*options*/) {
  return gitlab_codequality(check_gate(report));
}

}  // namespace raycheck::tools
