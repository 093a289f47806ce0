#ifndef RAYCHECK_TOOLS_GRADE_SUBMISSION_H_
#define RAYCHECK_TOOLS_GRADE_SUBMISSION_H_

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tools/external/locate.h"
#include "tools/grade/rubric.h"

namespace raycheck::tools {

/// What lies beside the submissions' folders.
inline constexpr const char* kClassPage = "index.html";
inline constexpr const char* kClassTable = "grades.csv";

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

/// Why nothing can be asked of a submission, and the candidate that its form makes of it, empty
/// where none fits.
class Refused : public std::invalid_argument {
 public:
  Refused(const std::string& why, std::string form)
      : std::invalid_argument(why), form_(std::move(form)) {}
  const std::string& form() const { return form_; }

 private:
  std::string form_;
};

/// A submission in a folder that its program may read, built where its form says so.
struct Prepared {
  External external;
  /// The candidate as --candidate would have it.
  std::string form;
};

/// Copies, builds and starts a submission, each step kept like a candidate.
/// Errors: Refused with what is wrong: no form fits, a compiler's message, a program
/// that does not introduce itself.
Prepared prepare(const Submission& submission, const Rubric& rubric, const Layers& layers);

/// A text about a submission without the names of raycheck's private folders, which differ from run
/// to run, and without what is no text.
std::string plain_text(std::string text);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_SUBMISSION_H_
