#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tools/grade/intake/handed_in.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// What someone handed in: a folder, or a single file.
struct Submission {
  std::string name;
  std::filesystem::path path;
};

/// The submissions by their names, which are those of the files or folders.
/// Errors: std::invalid_argument where there is none of that path, two of one name, or one of a
/// reserved name.
std::vector<Submission> find_submissions(const std::vector<std::string>& paths,
                                         const std::vector<std::string_view>& reserved);

/// Throws std::invalid_argument where a folder of results, or one of a submission's name in it, is,
/// holds or lies in what is handed in, whatever links lead there. It need not be there.
void require_apart(const std::string& out, const std::vector<Submission>& submissions);

/// How much is taken of a submission.
IntakeLimits intake_limits(const SubmissionLimits& limits);

/// Of its files' names and contents; where these cannot be read, of the reason.
/// Errors: std::system_error where that is the machine's (is_of_the_machine).
std::string digest(const Submission& submission, const SubmissionLimits& limits);

}  // namespace raycheck::tools
