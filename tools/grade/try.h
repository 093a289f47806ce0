#pragma once

#include <memory>
#include <string>

#include "properties/run_control.h"
#include "tools/grade/grade.h"

namespace raycheck::tools {

/// The part of a submission's grade that a student may see.
struct TryReport {
  std::shared_ptr<const Rubric> rubric;  ///< What `shown` refers to.
  StudentGrade shown;
  std::string folder;  ///< Where the page and the failing cases are; empty: nowhere.
  bool interrupted = false;

  /// Whether every item that is shown, and was asked, holds.
  bool holds() const;
};

/// Grades one submission as grade() does with the same rubric and seed, for its author: asks every
/// item, and shows those that students may see. `out`: the parent of the submission's folder of
/// results; empty: nothing is written.
/// Errors: as grade().
TryReport try_submission(const GradeOptions& options, const properties::RunControl& control = {});

std::string try_text(const TryReport& report);

}  // namespace raycheck::tools
