#ifndef RAYCHECK_TOOLS_GRADE_SUBMISSION_H_
#define RAYCHECK_TOOLS_GRADE_SUBMISSION_H_

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tools/external/locate.h"
#include "tools/grade/result.h"
#include "tools/grade/rubric.h"

namespace raycheck::tools {

/// What someone handed in: a folder, or a single file.
struct Submission {
  std::string name;
  std::filesystem::path path;
};

/// The submissions by their names, which are those of the files or folders.
/// Errors: std::invalid_argument where there is none of that path, or two of one name.
std::vector<Submission> find_submissions(const std::vector<std::string>& paths);

/// Of its files' names and contents.
std::string digest(const Submission& submission);

/// Why nothing can be asked of a submission, and the program that its form makes of it, absent
/// where none fits.
class SubmissionError : public std::invalid_argument {
 public:
  SubmissionError(Refusal refusal, std::optional<CandidateSpec> program)
      : std::invalid_argument(refusal.why),
        refusal_(std::move(refusal)),
        program_(std::move(program)) {}
  const Refusal& refusal() const { return refusal_; }
  const std::optional<CandidateSpec>& program() const { return program_; }

 private:
  Refusal refusal_;
  std::optional<CandidateSpec> program_;
};

/// A submission in a folder that its program may read, built where its form says so.
struct RunnableSubmission {
  External external;
  /// The candidate as --candidate would have it.
  CandidateSpec program;
};

/// Copies, builds and starts a submission, each step isolated like a candidate.
/// Errors: SubmissionError with what is wrong: no form fits, a compiler's message, a program
/// that does not introduce itself.
RunnableSubmission prepare(const Submission& submission, const Rubric& rubric,
                           const Layers& layers);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_SUBMISSION_H_
