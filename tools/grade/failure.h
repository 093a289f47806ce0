#ifndef RAYCHECK_TOOLS_GRADE_FAILURE_H_
#define RAYCHECK_TOOLS_GRADE_FAILURE_H_

// What there is to say about a case on which an item fails. Internal to grading.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "properties/laws/law.h"
#include "properties/trial.h"
#include "tools/external/external_candidate.h"
#include "tools/grade/result.h"
#include "tools/grade/rubric.h"

namespace raycheck::tools {

/// Who is judged, and how strictly.
struct Examinee {
  const properties::Candidate& candidate;
  const Tolerance& tolerance;
  bool pictures = false;
  bool masks_only = false;
  LastFailure last_failure = nullptr;  ///< Of someone else's candidate.

  properties::TrialOptions options(std::shared_ptr<properties::Truth> truth = nullptr) const {
    return {.max_error = tolerance.ulp, .truth = std::move(truth)};
  }
};

/// The numbers of a discrepancy, apart from its law.
WrongAnswer wrong_answer(const properties::Discrepancy& discrepancy);

/// The simplest case found that breaks the law in the same way as `from` does by `first`.
/// Domain: not a candidate that gave no answer in time, since every case tried might cost as long.
properties::Case simplest(const properties::Case& from, const properties::Law& law,
                          const properties::Discrepancy& first, const Examinee& examinee,
                          const std::function<bool()>& is_late);

/// What there is to say of a case, `first` being how it was found to fail; empty where it does not
/// break the law any more.
std::optional<FailingCase> failing_case(const properties::Case& the_case, const CaseOrigin& origin,
                                        const properties::Law& law,
                                        const properties::Discrepancy& first,
                                        const Examinee& examinee);

/// The mistakes that explain what is wrong on these cases.
std::vector<ExplainingMistake> explaining_mistakes(const std::vector<properties::Case>& cases,
                                                   const properties::Candidate& candidate,
                                                   bool pictures);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_FAILURE_H_
