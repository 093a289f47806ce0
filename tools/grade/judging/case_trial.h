#pragma once

// One case of an item, asked and judged. Internal to grading.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "properties/laws/law.h"
#include "properties/trial.h"
#include "tools/external/external_candidate.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// What is judged, and how strictly.
struct Examinee {
  const properties::Candidate& candidate;
  const Tolerance& tolerance;
  bool pictures = false;
  bool masks_only = false;             ///< Whether a pixel shows a sphere, not which.
  LastFailure last_failure = nullptr;  ///< For other people's candidates.

  properties::TrialOptions options() const { return {.max_error = tolerance.ulp}; }
};

/// The outcome of a case.
struct CaseOutcome {
  bool answers = false;  ///< There was something to ask.
  std::uint64_t compared = 0;
  properties::Verdict verdict;  ///< By all laws.
  ItemReason unanswered;        ///< Why some questions were not answered.
  const properties::Law* broken = nullptr;
  std::optional<properties::Discrepancy> discrepancy;
  std::optional<FailureKind> failure;  ///< The candidate's, if that is what breaks the law.
  bool is_answered() const { return unanswered.kind == ItemReason::Kind::kNone; }
  bool holds() const { return broken == nullptr && is_answered(); }
};

/// Tries the laws on a case.
CaseOutcome try_case(const std::vector<const properties::Law*>& laws,
                     const properties::Case& the_case, const Examinee& examinee);

}  // namespace raycheck::tools
