#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "properties/run_control.h"
#include "tools/external/sandbox/launch.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/pages/views.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/run/threads.h"
#include "tools/shards/units.h"

namespace raycheck::tools {

struct GradeOptions {
  std::string rubric = {};
  std::string dialect = {};  ///< Replaces the rubric's [driver] (see driver_rule()) if not empty.
  std::vector<std::string> submissions = {};
  std::string out = {};  ///< The folder of results, made if missing; if empty, nothing is written.
  bool for_student = false;  ///< Whether to write only the student's files, of one submission.
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

/// Calls `work` for every submission; the results are in order. If a failure is not the
/// submission's fault (`outside` of the result is not empty), the work is repeated at the end,
/// without other submissions running. `done` is the word for progress lines: "graded".
template <class Result>
std::vector<Result> done_for_each(
    const std::vector<Submission>& submissions, const properties::RunControl& control,
    const std::function<Result(const Submission&, bool alone)>& work) {
  std::vector<Result> all;
  in_order<Result>(
      static_cast<std::int64_t>(submissions.size()), control,
      [&](std::int64_t k) { return work(submissions[static_cast<std::size_t>(k)], false); },
      [&](Result& one) {
        const std::string state = fmt::format("{} of {} done", all.size() + 1, submissions.size());
        control.progress(state);
        control.done(state + ": " + submissions[all.size()].name);
        all.push_back(std::move(one));
      });
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].outside.empty() || control.interrupted()) continue;
    const std::string again = submissions[k].name + ": repeated, with no other submission running";
    control.progress(again);
    all[k] = work(submissions[k], true);
    control.done(again);
  }
  return all;
}

/// The parts of the submissions' grades that students may see.
struct TryReport {
  std::shared_ptr<const Rubric> rubric;  ///< What `shown` refers to.
  std::vector<StudentGrade> shown;       ///< In the given order.
  std::string out;                       ///< The folder of the results; empty: nothing is written.
  bool interrupted = false;

  /// Whether every item that is shown and was asked holds, of all submissions.
  bool holds() const;
};

/// Grades submissions for their authors, as grade() does with the same rubric and seed: asks every
/// item, and shows those that students may see.
/// Errors: as grade().
TryReport try_submission(GradeOptions options, const properties::RunControl& control = {});

std::string try_text(const TryReport& report);

/// Tries the rubric on two correct submissions: raycheck's own methods as a library and as a
/// renderer.
std::vector<SubmissionGrade> try_rubric(const Rubric& rubric, std::uint64_t seed,
                                        const properties::RunControl& control = {});

/// Judges correct submissions that come with raycheck, one of each kind that the rubric's forms
/// accept. If one fails, the environment is broken.
/// Errors: std::invalid_argument.
void test_environment(const Rubric& rubric, const Layers& layers);

/// Writes the zip file of a Gradescope autograder. It contains setup.sh, run_autograder, the rubric
/// with its scenes, and raycheck with its libraries except those of C and C++. Errors:
/// std::invalid_argument or std::runtime_error naming the file.
void write_package(const Rubric& rubric, std::uint64_t seed, const std::string& path);

}  // namespace raycheck::tools
