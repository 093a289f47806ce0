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

/// How far a submission got, and what was learned on the way.
struct Preparation {
  /// The candidate as for --candidate; absent if no form fits.
  std::optional<CandidateSpec> program = {};
  std::vector<std::string> files = {};  ///< The names of those at the top, with notebooks' modules.
  bool built_automatically = false;     ///< Its form lets raycheck find out how to build it.
  /// The shell command that built it; empty: nothing had to be built, or raycheck compiled it.
  std::string build_words = {};
  std::optional<double> build_seconds = {};  ///< Absent: nothing was built that can be started.
  /// Remarks on the build: "its Makefile failed; built from its sources".
  std::vector<std::string> notes = {};
  std::optional<DryRun> dry_run = {};  ///< For a renderer.
  std::vector<OpaqueFile> opaque_files = {};

  /// Those on the build and on the dry run, as plain text.
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
  /// How far it came: kNothing where it could not even be started.
  Progress progress() const { return found_.dry_run ? found_.dry_run->progress : Progress(); }

 private:
  Refusal refusal_;
  Preparation found_;
};

/// A submission in a folder that its program may read, built if its form says so.
struct RunnableSubmission {
  External external;
  Preparation found;             ///< With a program.
  bool build_is_stored = false;  ///< Built by an earlier run, or for an equal submission.
};

/// How a submission is isolated, and who is told about failures with an outside cause.
struct Confinement {
  Layers layers;
  std::shared_ptr<Surroundings> surroundings = {};
};

/// Control of work on a submission that also ends on an outside cause of failure.
properties::RunControl until_blamed(const properties::RunControl& control,
                                    const Surroundings& surroundings);

/// The refusal for such a cause.
Refusal outside_refusal(const std::string& cause);

/// The limits of a submission's program, with the rubric's names for them.
Limits program_limits(const Rubric& rubric);

/// Copies, builds and starts a submission, each step isolated like a candidate; a renderer makes a
/// few pictures, so that it is asked in the form that it reads. Of several programs that are built
/// the first that shows spheres, or introduces itself, is taken, else the first that makes a
/// picture; where none shows spheres, a form that is built automatically is built in other ways,
/// too. What a store has is neither built nor asked again.
/// Errors: SubmissionError with what is wrong: no form fits, a compiler's message, a program that
/// does not introduce itself, or makes no picture; of several programs and ways to build them, that
/// of the one that came farthest.
RunnableSubmission prepare(const Submission& submission, const Rubric& rubric,
                           const Confinement& confinement,
                           const properties::RunControl& control = {}, Store* store = nullptr);

}  // namespace raycheck::tools
