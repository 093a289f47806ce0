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
#include "tools/grade/result.h"
#include "tools/grade/rubric.h"

namespace raycheck::tools {

/// Who is asked what, how strictly.
struct Asking {
  const properties::Candidate& candidate;
  const Tolerance& tolerance;
  bool pictures = false;
  bool masks_only = false;
  scene::Dialect dialect = scene::Dialect::kB;

  properties::TrialOptions options(std::shared_ptr<properties::Truth> truth = nullptr) const {
    return {.max_error = tolerance.ulp, .truth = std::move(truth)};
  }
};

/// "class, pixel (3, 4), sphere 0: missed"
std::string head(const properties::Discrepancy& discrepancy);

/// A failing case that is simpler and breaks the law in the same way as `first`.
properties::Case simplest(const properties::Case& from, const properties::Law& law,
                          const properties::Discrepancy& first, const Asking& asking,
                          const std::function<bool()>& is_late);

/// A case in words, `first` being how it was found to fail; empty where it does not break the law
/// any more.
std::optional<FailingCase> failing_case(const properties::Case& the_case, const std::string& origin,
                                        const properties::Law& law,
                                        const properties::Discrepancy& first, const Asking& asking);

/// The mistakes that explain what is wrong on these cases.
std::vector<std::string> mistake_sentences(const std::vector<properties::Case>& cases,
                                           const properties::Candidate& candidate, bool pictures);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_FAILURE_H_
