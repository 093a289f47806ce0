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
  std::string dialect = {};  ///< Replaces the rubric's [driver]; see driver_rule().
  std::string submission;
  std::string
      out;  ///< The parent of the submission's folder of results; empty: nothing is written.
  std::uint64_t seed = 1;
  Sandbox sandbox = Sandbox::kAvailable;
};

/// The part of a submission's grade that a student may see.
struct TryReport {
  std::shared_ptr<const Rubric> rubric;  ///< What `shown` refers to.
  StudentGrade shown;
  std::string folder;  ///< Where the page and the failing cases are; empty: nowhere.
  bool interrupted = false;

  /// Whether every item that is shown, and was asked, holds.
  bool holds() const;
};

/// Grades a submission as grade() does with the same rubric and seed, for its author: asks every
/// item, and shows those that students may see.
/// Errors: as grade().
TryReport try_submission(const TryOptions& options, const properties::RunControl& control = {});

std::string try_text(const TryReport& report);

}  // namespace raycheck::tools
