#include "tools/grade/judging/case_trial.h"

#include <algorithm>
#include <string>
#include <utility>

namespace raycheck::tools {

using properties::Case;
using properties::Law;
using properties::Needs;
using properties::Trial;
using properties::Verdict;
using properties::Wrong;

namespace {

/// Whether the candidate misses hits, or has them at the other root, so that laws about hits have
/// less to compare; what is excused does not count.
bool misses_hits(Trial& trial) {
  for (const Law& law : properties::laws()) {
    if (!judges_decisions(law) || !needs_any(law.needs, Needs::kIntersect)) continue;
    if (!what_is_missing(law.needs, trial).empty()) continue;
    const auto defects = apply(law, trial).defects();
    if (std::any_of(defects.begin(), defects.end(), [](const properties::DefectKind& defect) {
          return defect.wrong == Wrong::kMissed || defect.wrong == Wrong::kWrongRoot;
        })) {
      return true;
    }
  }
  return false;
}

bool has_hits(Trial& trial) {
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    for (const properties::Meeting& meeting : trial.exact_meetings(sphere)) {
      const bool is_judged =
          !properties::is_unjudged(meeting.intersection, trial.conventions().tangent);
      if (is_judged && trial.exact_hit(meeting.ray, sphere)) return true;
    }
  }
  return false;
}

/// Whether the candidate gives a law less to compare than the scene has.
bool is_unanswered(const Law& law, Trial& trial) {
  if (law.per == properties::Per::kImage || !scene_suits(law.needs, trial)) return false;
  const bool lacks_functions = !what_is_missing(law.needs, trial).empty();
  // The law of the class compares misses, too; those of no stage look at hits where there are some.
  const bool is_of_class = judges_decisions(law) && law.quantity == properties::Quantity::kClass;
  const bool compares_hits =
      needs_any(law.needs, Needs::kIntersect) || (needs_any(law.needs, Needs::kRays) && !law.stage);
  if (is_of_class || !compares_hits) return lacks_functions;
  return has_hits(trial) && (lacks_functions || misses_hits(trial));
}

}  // namespace

CaseOutcome try_case(const std::vector<const Law*>& laws, const Case& the_case,
                     const Examinee& examinee) {
  Trial trial(the_case, examinee.candidate, examinee.options());
  CaseOutcome outcome;
  for (const Law* law : laws) {
    Verdict verdict = apply(*law, trial);
    // Of pictures every pixel is compared.
    const bool unanswered = !examinee.pictures && verdict.holds() && is_unanswered(*law, trial);
    outcome.compared += verdict.compared();
    outcome.answers = outcome.answers || verdict.compared() > 0 || unanswered;
    // A renderer with colours of its own does not tell which sphere it sees.
    const bool is_untold =
        examinee.pictures && !examinee.masks_only && the_case.scene.spheres.size() > 1;
    if (!verdict.holds()) {
      if (outcome.broken != nullptr) continue;
      outcome.broken = law;
      outcome.discrepancy = verdict.worst(1).front();
      if (outcome.discrepancy->wrong == properties::Wrong::kFailed && examinee.last_failure) {
        outcome.failure = *examinee.last_failure;
      }
    } else if (is_untold && !verdict.reason_left_out().empty()) {
      outcome.unanswered = {.kind = ItemReason::Kind::kOtherColours};
    } else if (unanswered && outcome.is_answered()) {
      outcome.unanswered = {.kind = ItemReason::Kind::kUnanswered,
                            .law = std::string(law->name),
                            .said = verdict.reason_left_out()};
    }
    outcome.verdict.merge(std::move(verdict));
  }
  return outcome;
}

}  // namespace raycheck::tools
