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
#include "tools/grade/intake/submission.h"
#include "tools/grade/results/result.h"
#include "tools/grade/store/store.h"

namespace raycheck::tools {

/// How far a submission came, and what was found out on the way.
struct Preparation {
  /// The candidate as --candidate would have it; absent where no form fits.
  std::optional<CandidateSpec> program = {};
  std::vector<std::string> files = {};  ///< The names of those at its top, notebooks' modules too.
  bool built_automatically = false;     ///< Its form leaves to raycheck how it is built.
  /// The shell words that built it; empty: nothing was to build, or raycheck compiled it.
  std::string build_words = {};
  std::optional<double> build_seconds = {};  ///< Absent: nothing was built that can be started.
  /// What is worth knowing of how it was built: "its Makefile failed; built from its sources".
  std::vector<std::string> notes = {};
  std::optional<DryRun> dry_run = {};  ///< Of a renderer.
  std::vector<OpaqueFile> opaque_files = {};
};

/// Why nothing can be asked of a submission.
class SubmissionError : public std::invalid_argument {
 public:
  SubmissionError(Refusal refusal, Preparation found)
      : std::invalid_argument(refusal.why),
        refusal_(std::move(refusal)),
        found_(std::move(found)) {}
  const Refusal& refusal() const { return refusal_; }
  const Preparation& found() const { return found_; }
  /// How far it came: kNothing where it could not even be started.
  Progress progress() const { return found_.dry_run ? found_.dry_run->progress : Progress(); }

 private:
  Refusal refusal_;
  Preparation found_;
};

/// A submission in a folder that its program may read, built where its form says so.
struct RunnableSubmission {
  External external;
  Preparation found;             ///< With a program.
  bool build_is_stored = false;  ///< It was built by an earlier run, or for an equal submission.
};

/// How a submission is kept, and who is told where it fails for a cause outside it.
struct Confinement {
  Layers layers;
  std::shared_ptr<Surroundings> surroundings = {};
};

/// Work on a submission, which ends too where it fails for a cause outside it.
properties::RunControl until_blamed(const properties::RunControl& control,
                                    const Surroundings& surroundings);

/// What is said where it did.
Refusal outside_refusal(const std::string& cause);

/// What a submission's program may use, by the names that the rubric has for it.
Limits program_limits(const Rubric& rubric);

/// Copies, builds and starts a submission, each step isolated like a candidate; a renderer makes a
/// few pictures, so that it is asked in the form that it reads. Of several programs that are built
/// the first that shows spheres, or introduces itself, is taken, else the first that makes a
/// picture. What a store has is neither built nor asked again.
/// Errors: SubmissionError with what is wrong: no form fits, a compiler's message, a program that
/// does not introduce itself, or makes no picture; of several programs, that of the one that came
/// farthest.
RunnableSubmission prepare(const Submission& submission, const Rubric& rubric,
                           const Confinement& confinement,
                           const properties::RunControl& control = {}, Store* store = nullptr);

}  // namespace raycheck::tools
