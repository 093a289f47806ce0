#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tools/grade/intake/handed_in.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// A submission: a folder, or a single file.
struct Submission {
  std::string name;
  std::filesystem::path path;
};

/// The submissions by their names, which are those of the files or folders.
/// Errors: std::invalid_argument if a path does not exist, two names are equal, or a name is
/// reserved.
std::vector<Submission> find_submissions(const std::vector<std::string>& paths,
                                         const std::vector<std::string_view>& reserved);

/// Throws std::invalid_argument if the folder of results, or a submission's folder in it, is,
/// contains or lies in a submission, also through links. It need not exist.
void require_disjoint(const std::string& out, const std::vector<Submission>& submissions);

/// A digest of its files' names and contents or, if these cannot be read, of the reason.
/// Errors: std::system_error if that is the machine's fault (is_of_the_machine).
std::string digest(const Submission& submission, const SubmissionLimits& limits);

}  // namespace raycheck::tools
