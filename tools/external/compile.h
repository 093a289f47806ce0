#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "tools/external/locate.h"

namespace raycheck::tools {

/// Where <raycheck/candidate.h> is: beside an installed program, or in the sources it was built of.
std::filesystem::path include_folder();

/// What a source that is compiled lies in, with all that it may include beside itself: the folder,
/// or that of the file.
std::filesystem::path source_folder(const std::filesystem::path& source);

/// Compiles a C++ file, the .cpp files of a folder, or what a CMakeLists.txt describes, to a shared
/// library with tables of lines in the folder `to`, kept like a candidate; the library's path.
/// <raycheck/candidate.h> and Eigen, where it is installed, are found. Errors: CandidateError with
/// what the compiler said.
std::filesystem::path compile(const std::filesystem::path& source, const std::filesystem::path& to,
                              const RunOptions& options);

/// Shell words that build something.
struct BuildWords {
  std::string words;
  std::string shown;  ///< What errors call them.
  /// Whether a file that lies there afterwards is copied; empty: all are.
  std::function<bool(const std::filesystem::path& file)> keeps = {};
};

/// Runs shell words in a copy of a folder, kept like a candidate, and copies what lies there
/// afterwards to the folder `to`: files with their times, no links. The Java adapter lies there
/// too.
/// Errors: CandidateError with what the words said.
void build(const std::filesystem::path& folder, const BuildWords& words,
           const std::filesystem::path& to, const RunOptions& options);

}  // namespace raycheck::tools
