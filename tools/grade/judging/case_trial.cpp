#include "tools/grade/judging/case_trial.h"

#include <string>
#include <utility>

#include "tools/implementations/built_in.h"

namespace raycheck::tools {

using properties::Candidate;
using properties::Case;
using properties::Law;
using properties::Trial;
using properties::Truth;
using properties::Verdict;

namespace {

/// Whether answers may be missing: if a decision about the case is excused or undecided and differs
/// from raycheck's, there is a hit less to compare.
bool may_miss_answers(Trial& trial) {
  for (const Law& law : properties::laws()) {
    if (!judges_decisions(law) || law.per == properties::Per::kImage) continue;
    const Verdict verdict = apply(law, trial);
    if (verdict.holds() && verdict.discrepancies() > 0) return true;
  }
  return false;
}

}  // namespace

CaseOutcome try_case(const std::vector<const Law*>& laws, const Case& the_case,
                     const Examinee& examinee) {
  Candidate own = candidate_of(kDefaultMethods);
  own.declared = examinee.candidate.declared;
  const auto truth =
      std::make_shared<Truth>(the_case, own.declared.over(the_case.scene.conventions));
  Trial trial(the_case, examinee.candidate, examinee.options(truth));
  Trial own_trial(the_case, own, examinee.options(truth));
  CaseOutcome outcome;
  for (const Law* law : laws) {
    Verdict verdict = apply(*law, trial);
    // raycheck's own methods draw no pictures, of which every pixel is compared.
    const std::uint64_t expected = examinee.pictures ? 0 : apply(*law, own_trial).compared();
    outcome.compared += verdict.compared();
    outcome.answers = outcome.answers || verdict.compared() > 0 || expected > 0;
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
    } else if (verdict.compared() < expected && outcome.is_answered() && !may_miss_answers(trial)) {
      outcome.unanswered = {.kind = ItemReason::Kind::kUnanswered,
                            .law = std::string(law->name),
                            .said = verdict.reason_left_out()};
    }
    outcome.verdict.merge(std::move(verdict));
  }
  return outcome;
}

}  // namespace raycheck::tools
