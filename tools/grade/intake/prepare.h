#pragma once

#include <stdexcept>
#include <utility>

#include "properties/run_control.h"
#include "tools/external/locate.h"
#include "tools/external/pictures/dry_run.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/results/result.h"
#include "tools/grade/store/store.h"

namespace raycheck::tools {

/// Why a submission cannot be judged.
struct SubmissionError : std::invalid_argument {
  SubmissionError(Refusal given, Preparation until_then)
      : std::invalid_argument(given.why), refusal(std::move(given)), found(std::move(until_then)) {}
  /// How far it got: kNothing if it could not be started.
  Progress progress() const { return found.dry_run ? found.dry_run->progress : Progress(); }

  Refusal refusal;
  Preparation found;
};

/// A submission in a folder that its program may read, built if its form says so.
struct RunnableSubmission {
  External external;
  Preparation found;             ///< Its `program` is set.
  bool build_is_stored = false;  ///< Built by an earlier run or for an equal submission.
};

/// How a submission is built and run: the rubric's limits, with its names for them.
RunOptions run_options(const Rubric& rubric, const Layers& layers);

/// Copies, builds and starts a submission with run_options(), each step isolated like a candidate.
/// A renderer draws a few pictures in a dry run, which finds the form that it reads. Of several
/// built programs the first that shows spheres, or introduces itself, is taken, else the first that
/// makes a picture. If no program shows spheres and the form has build = "auto", other ways to
/// build are tried. Builds and answers in the store are reused. Errors: SubmissionError: no form
/// fits, the build fails, the program does not introduce itself or makes no picture; of several
/// programs and builds, the error of the one that got farthest.
RunnableSubmission prepare(const Submission& submission, const Rubric& rubric, RunOptions options,
                           const properties::RunControl& control, Store* store);

}  // namespace raycheck::tools
