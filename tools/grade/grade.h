#ifndef RAYCHECK_TOOLS_GRADE_GRADE_H_
#define RAYCHECK_TOOLS_GRADE_GRADE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/run_control.h"
#include "tools/grade/class_grade.h"
#include "tools/grade/views.h"

namespace raycheck::tools {

struct GradeOptions {
  std::string rubric;
  std::vector<std::string> submissions;
  std::string out;  ///< A folder; it is made.
  std::uint64_t seed = 1;
  std::optional<std::string> secret;  ///< Seeds follow from it and the submissions' names.
  Sandbox sandbox = Sandbox::kAuto;
  /// What is written of each submission for a course's system, besides what always is; null:
  /// nothing.
  const ResultsFormat* results = nullptr;
};

/// Grades every submission: OUT/NAME/ has its report.html and the failing scenes for the student,
/// and result.json for instructors, as soon as it is done; OUT has the pages of the class at the
/// end. What an earlier run into the same folder finished, of the same files by the same rubric and
/// seed, is not graded again. Errors: what load_rubric(), find_submissions() and chosen_layers()
/// throw.
ClassGrade grade(const GradeOptions& options, const properties::RunControl& control = {});

/// The rubric tried on raycheck's own methods, as a library and as a renderer: what a right
/// submission is given.
std::vector<SubmissionGrade> try_rubric(const Rubric& rubric, std::uint64_t seed,
                                        const properties::RunControl& control = {});

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_GRADE_H_
