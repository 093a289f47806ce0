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
  return {std::string(discrepancy.law), report.path,
          kind_text({discrepancy.quantity, discrepancy.wrong}), place_of(discrepancy),
          candidate.name};
}

/// What is held against a candidate, the worst first.
std::vector<Discrepancy> defects_of(const CheckReport& report, const CandidateReport& candidate) {
  std::vector<Discrepancy> defects = candidate.verdict.worst(properties::kKeptDiscrepancies);
  std::erase_if(defects, [&](const Discrepancy& one) {
    return !properties::is_held_against(one, report.strict);
  });
  return defects;
}

std::string text_of(const CheckReport& report, const CandidateReport& candidate,
                    const std::vector<Discrepancy>& defects) {
  const External* const external = external_of(candidate.contestant);
  const bool renders = external != nullptr && external->renderer;
  std::string text = explanations_text(candidate.explanations, renders ? "pixels" : "answers");
  for (std::size_t k = 0; k < std::min(defects.size(), report.top); ++k) {
    text += fmt::format("{}. {}", k + 1, discrepancy_text(defects[k], false));
  }
  return text;
}

GateCheck check_of(Quantity quantity, const Tally& tally, const CheckReport& report,
                   const CandidateReport& candidate) {
  std::vector<Discrepancy> defects = defects_of(report, candidate);
  std::erase_if(defects, [&](const Discrepancy& one) { return one.quantity != quantity; });
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
  check.outcome = outcome_of(check.defects, report.ratchet);
  if (!defects.empty()) {
    const auto& why = candidate.explanations;
    check.summary = fmt::format("{}{} at {}", why.empty() ? "" : why.front().sentence + ": ",
                                check.defects.front().kind, place_text(defects.front().place));
    check.text = text_of(report, candidate, defects);
  } else if (tally.count(Standing::kUndecided) > 0) {
    check.outcome = GateOutcome::kInconclusive;
    check.summary = count_text(tally.count(Standing::kUndecided), "answer") + " undecided";
  } else if (tally.cases == 0) {
    check.outcome = GateOutcome::kLeftOut;
    check.summary = "nothing to compare";
  }
  return check;
}

void add_checks(Gate& gate, const CheckReport& report, const CandidateReport& candidate) {
  if (const External* const external = external_of(candidate.contestant);
      external != nullptr && !external->source_file.empty()) {
    gate.sources.push_back({candidate.name, external->source_file});
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
    const auto defects = defects_of(report, candidate);
    for (const Discrepancy& one : defects) {
      findings.found.insert(identity_of(one, report, candidate));
    }
    // Of more discrepancies than are kept, those that are not there may have been dropped.
    const bool has_all = candidate.verdict.discrepancies() < properties::kKeptDiscrepancies;
    if (report.interrupted || !has_all || !candidate.is_enough_judged()) continue;
    for (const properties::Law& law : properties::laws()) {
      findings.asked.insert({std::string(law.name), report.path, candidate.name});
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
