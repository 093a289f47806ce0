#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "properties/run_control.h"
#include "tools/external/sandbox/process.h"
#include "tools/grade/results/redaction.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

struct TryOptions {
  std::string rubric;
  std::string dialect = {};  ///< In place of the rubric's [driver], as driver_rule() takes it.
  std::string submission;
  std::string
      out;  ///< A folder that takes one of the submission's name; empty: nothing is written.
  std::uint64_t seed = 1;
  Sandbox sandbox = Sandbox::kAvailable;
};

/// What a student may see of the grade of a submission.
struct TryReport {
  std::shared_ptr<const Rubric> rubric;  ///< What `shown` refers to.
  StudentGrade shown;
  std::string folder;  ///< Where the page and the failing cases lie; empty: nowhere.
  bool interrupted = false;

  /// Every item that is shown, and was asked, holds.
  bool holds() const;
};

/// Grades a submission as grade() does with the same rubric and seed, for its author: every item is
/// asked, and those are shown that students may see.
/// Errors: what grade() throws.
TryReport try_submission(const TryOptions& options, const properties::RunControl& control = {});

std::string try_text(const TryReport& report);

}  // namespace raycheck::tools
