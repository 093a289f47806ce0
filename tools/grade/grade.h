#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "properties/run_control.h"
#include "tools/grade/pages/views.h"
#include "tools/grade/results/redaction.h"
#include "tools/grade/results/result.h"

namespace raycheck::tools {

struct GradeOptions {
  std::string rubric;
  std::string dialect = {};  ///< In place of the rubric's [driver], as driver_rule() takes it.
  std::vector<std::string> submissions;
  std::string out;  ///< A folder; it is made. Empty: nothing is written.
  std::uint64_t seed = 1;
  std::optional<std::string> secret;  ///< Seeds follow from it and the submissions' names.
  Sandbox sandbox = Sandbox::kRequire;
  std::string against = {};  ///< The folder of an earlier run's results, maybe `out`; empty: none.
  /// What is written of each submission for a course's system, besides what always is; null:
  /// nothing.
  const ResultsFormat* results = nullptr;
};

/// Grades every submission: OUT/NAME/ has its report.html, figures.html and the failing scenes for
/// the student, and result.json for instructors, as soon as it is done; OUT has the pages of the
/// class at the end. What an earlier run into the same folder finished, of the same files by the
/// same rubric and seed, is not graded again; of what has changed what was built and answered is
/// kept there (store.h). Files that raycheck did not write are neither replaced nor removed.
/// Errors, before anything is written: what load_rubric(), find_submissions(), chosen_layers(),
/// require_apart() and OwnFiles::require_own() throw.
ClassGrade grade(const GradeOptions& options, const properties::RunControl& control = {});

/// What a student is given: a page, the failing scenes as TOML and as driver files, and figures of
/// those of functions; by the names of the files.
std::map<std::string, std::string> files_for_student(const StudentGrade& shown);

/// The names that these may have.
std::vector<std::string> names_for_student(const Rubric& rubric);

/// The rubric tried on raycheck's own methods, as a library and as a renderer: what a right
/// submission is given.
std::vector<SubmissionGrade> try_rubric(const Rubric& rubric, std::uint64_t seed,
                                        const properties::RunControl& control = {});

}  // namespace raycheck::tools
