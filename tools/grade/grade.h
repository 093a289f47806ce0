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
#include "tools/run/in_order.h"
#include "tools/shards/units.h"

namespace raycheck::tools {

struct GradeOptions {
  std::string rubric = {};
  std::string dialect = {};  ///< Replaces the rubric's [driver]; see driver_rule().
  std::vector<std::string> submissions = {};
  std::string out = {};      ///< The folder, made if missing. Empty: nothing is written.
  bool for_student = false;  ///< Of one submission, only what its student gets is written.
  std::uint64_t seed = 1;
  std::optional<std::string> secret = {};  ///< Seeds follow from it and the submissions' names.
  Sandbox sandbox = Sandbox::kRequire;
  /// The results file written for a course's system, besides the usual files; null: none.
  const ResultsFormat* results = nullptr;
};

/// Grades every submission: OUT/NAME/ has its report.html, figures.html and the failing scenes for
/// the student, and result.json for instructors, as soon as it is done; OUT gets the class pages at
/// the end. What an earlier run into the same folder built and asked is neither built nor asked
/// again (store.h). Files that raycheck did not write are neither replaced nor removed. Errors,
/// before anything is written: what load_rubric(), find_submissions(), chosen_layers(),
/// require_disjoint() and OwnFiles::require_own() throw. With `units`, which only note who is
/// graded, those of their shard that are not; if they are not all, OUT gets no class pages.
ClassGrade grade(const GradeOptions& options, const properties::RunControl& control = {},
                 Units* units = nullptr);

/// Does something for every submission, in their order; what fails for a cause outside it
/// (`outside` of a result says which) is done again at the end, when nothing runs beside it.
/// `done`: "graded".
template <class Result>
std::vector<Result> done_for_each(
    const std::vector<Submission>& submissions, const properties::RunControl& control,
    const std::string& done, const std::function<Result(const Submission&, bool alone)>& work) {
  std::vector<Result> all;
  in_order<Result>(
      static_cast<std::int64_t>(submissions.size()), control,
      [&](std::int64_t k) { return work(submissions[static_cast<std::size_t>(k)], false); },
      [&](Result& one) {
        const std::string state =
            fmt::format("{} of {} {}", all.size() + 1, submissions.size(), done);
        control.progress(state);
        control.done(state + ": " + submissions[all.size()].name);
        all.push_back(std::move(one));
      });
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].outside.empty() || control.interrupted()) continue;
    control.progress(submissions[k].name + " again, alone");
    all[k] = work(submissions[k], true);
    control.done(done + " again, alone: " + submissions[k].name);
  }
  return all;
}

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
TryReport try_submission(GradeOptions options, const properties::RunControl& control = {});

std::string try_text(const TryReport& report);

/// Tries the rubric on raycheck's own methods, as a library and as a renderer: the grade of a
/// correct submission.
std::vector<SubmissionGrade> try_rubric(const Rubric& rubric, std::uint64_t seed,
                                        const properties::RunControl& control = {});

/// Judges raycheck's own, correct submissions, one of each kind that the rubric's forms accept: if
/// they fail, so would the students', through no fault of theirs.
/// Errors: std::invalid_argument with what is wrong.
void test_environment(const Rubric& rubric, const Layers& layers);

/// Writes the zip file of a Gradescope autograder: setup.sh and run_autograder, the rubric with its
/// scenes, and raycheck with the libraries that it needs besides those of C and C++.
/// Errors: std::invalid_argument or std::runtime_error naming the file.
void write_package(const Rubric& rubric, std::uint64_t seed, const std::string& path);

}  // namespace raycheck::tools
