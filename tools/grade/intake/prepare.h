#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "properties/run_control.h"
#include "tools/external/locate.h"
#include "tools/external/pictures/dry_run.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/results/result.h"
#include "tools/grade/store/store.h"

namespace raycheck::tools {

/// The findings about a submission while it is prepared, as far as it got.
struct Preparation {
  /// The candidate as for --candidate; absent if no form fits.
  std::optional<CandidateSpec> program = {};
  std::vector<std::string> files = {};  ///< The files at the top, with notebooks' modules.
  std::string adapter = {};             ///< The name of its form's adapter; or empty.
  bool built_automatically = false;     ///< Its form has build = "auto".
  /// The shell command that built it; empty: nothing had to be built, or raycheck compiled it.
  std::string build_words = {};
  std::optional<double> build_seconds = {};  ///< Absent: there is no program to start.
  /// Remarks on the build: "its Makefile failed; built from its sources".
  std::vector<std::string> notes = {};
  std::optional<DryRun> dry_run = {};  ///< For a renderer.
  std::vector<OpaqueFile> opaque_files = {};

  /// The notes on the build and on the dry run, as plain text.
  std::vector<std::string> all_notes() const;
};

/// Why a submission cannot be judged.
class SubmissionError : public std::invalid_argument {
 public:
  SubmissionError(Refusal refusal, Preparation found)
      : std::invalid_argument(refusal.why),
        refusal_(std::move(refusal)),
        found_(std::move(found)) {}
  const Refusal& refusal() const { return refusal_; }
  const Preparation& found() const { return found_; }
  /// How far it got: kNothing if it could not be started.
  Progress progress() const { return found_.dry_run ? found_.dry_run->progress : Progress(); }

 private:
  Refusal refusal_;
  Preparation found_;
};

/// A submission in a folder that its program may read, built if its form says so.
struct RunnableSubmission {
  External external;
  Preparation found;             ///< Its `program` is set.
  bool build_is_stored = false;  ///< Built by an earlier run or for an equal submission.
};

/// How a submission is isolated, and where failures with an outside cause are recorded.
struct Confinement {
  Layers layers;
  std::shared_ptr<Surroundings> surroundings = {};
};

/// A RunControl that also interrupts when an outside cause of failure is recorded.
properties::RunControl until_blamed(const properties::RunControl& control,
                                    const Surroundings& surroundings);

/// The refusal for an outside cause.
Refusal outside_refusal(const std::string& cause);

/// The limits of a submission's program, with the rubric's names for them.
Limits program_limits(const Rubric& rubric);

/// Copies, builds and starts a submission, each step isolated like a candidate. A renderer draws a
/// few pictures in a dry run, which finds the form that it reads. Of several built programs the
/// first that shows spheres, or introduces itself, is taken, else the first that makes a picture.
/// If no program shows spheres and the form has build = "auto", other ways to build are tried.
/// Builds and answers in the store are reused. Errors: SubmissionError: no form fits, the build
/// fails, the program does not introduce itself or makes no picture; of several programs and
/// builds, the error of the one that got farthest.
RunnableSubmission prepare(const Submission& submission, const Rubric& rubric,
                           const Confinement& confinement,
                           const properties::RunControl& control = {}, Store* store = nullptr);

}  // namespace raycheck::tools
