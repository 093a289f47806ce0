#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/run_control.h"
#include "tools/external/sandbox/launch.h"
#include "tools/grade/pages/views.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/shards/units.h"

namespace raycheck::tools {

struct GradeOptions {
  std::string rubric = {};
  std::string dialect = {};  ///< Replaces the rubric's [driver] (see driver_rule()) if not empty.
  std::vector<std::string> submissions = {};
  std::string out = {};  ///< The folder of results, made if missing; if empty, nothing is written.
  bool for_student = false;  ///< Whether to write only the students' files.
  bool probe = false;  ///< Whether to build and try the submissions, but judge and write nothing.
  std::uint64_t seed = 1;
  std::optional<std::string> secret = {};  ///< If given, each submission's seed is derived from it.
  Sandbox sandbox = Sandbox::kRequire;
  /// The format of an additional results file for a course's system; null if there is none.
  const ResultsFormat* results = nullptr;
};

/// Grades every submission. As soon as a submission is graded, report.html, figures.html and the
/// failing scenes (for the student) and result.json (for instructors) are written to OUT/NAME/; at
/// the end, the class pages are written to OUT. Builds and answers of earlier runs into the same
/// folder are reused (store.h). Files that raycheck did not write are neither replaced nor removed.
/// Errors, before anything is written: what load_rubric(), find_submissions(), chosen_layers(),
/// require_disjoint() and OwnFiles::require_own() throw. If `units` is given, grades the
/// submissions of the shard whose units are missing; a unit only records that a submission was
/// graded. Unless the shard is the whole class, no class pages are written.
ClassGrade grade(const GradeOptions& options, const properties::RunControl& control = {},
                 Units* units = nullptr);

/// Tries the rubric on two correct submissions: raycheck's own methods as a library and as a
/// renderer.
ClassGrade try_rubric(const GradeOptions& options, const properties::RunControl& control);

/// Judges correct submissions that come with raycheck, one of each kind that the rubric's forms
/// accept. If one fails, the environment is broken.
/// Errors: std::invalid_argument.
void test_environment(const Rubric& rubric, const Layers& layers);

/// Writes the zip file of a Gradescope autograder. It contains setup.sh, run_autograder, the rubric
/// with its scenes, and raycheck with its libraries except those of C and C++. Errors:
/// std::invalid_argument or std::runtime_error naming the file.
void write_package(const Rubric& rubric, std::uint64_t seed, const std::string& path);

}  // namespace raycheck::tools
