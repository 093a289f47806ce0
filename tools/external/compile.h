#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "tools/external/locate.h"

namespace raycheck::tools {

/// Where <raycheck/candidate.h> is: beside an installed program, or in the sources it was built of.
std::filesystem::path include_folder();

/// The folder of a source to compile, with all that it may include: itself, or the file's folder.
std::filesystem::path source_folder(const std::filesystem::path& source);

struct Compiled {
  std::filesystem::path library;
  std::set<std::string> read;  ///< The files that the compiler read of the source's folder.
};
/// Compiles a C++ file, the .cpp files of a folder, or what a CMakeLists.txt describes, to a shared
/// library with line tables in the folder `to`, sandboxed like a candidate.
/// <raycheck/candidate.h> and Eigen, if installed, are found. Errors: CandidateError with
/// what the compiler said.
Compiled compile(const std::filesystem::path& source, const std::filesystem::path& to,
                 const RunOptions& options);

/// A shell command that builds something.
struct BuildWords {
  std::string words;
  std::string shown;  ///< Its name in errors.
  /// Whether to copy a file found afterwards; empty: copy all.
  std::function<bool(const std::filesystem::path& file)> keeps = {};
};

/// Runs a shell command in a copy of a folder, sandboxed like a candidate, and copies what is there
/// afterwards to the folder `to`: files with their times, no links. The Java adapter is provided,
/// too.
/// Errors: CandidateError with the command's output.
void build(const std::filesystem::path& folder, const BuildWords& words,
           const std::filesystem::path& to, const RunOptions& options);

}  // namespace raycheck::tools
