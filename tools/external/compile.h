#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include "tools/external/locate.h"

namespace raycheck::tools {

/// The folder with raycheck/candidate.h: in the installation or, if raycheck is not installed, in
/// its sources.
std::filesystem::path include_folder();

/// The folder of a source to compile: the source itself if it is a folder, otherwise the folder
/// that contains it.
std::filesystem::path source_folder(const std::filesystem::path& source);

struct Compiled {
  std::filesystem::path library;
  std::set<std::string> read;  ///< The files in the source's folder that the compiler read.
};
/// Compiles a C++ file, the .cpp files of a folder, or a project with a CMakeLists.txt. The result
/// is a shared library with line tables in the folder `to`. The compiler is sandboxed like a
/// candidate; raycheck/candidate.h, Eigen, if installed, the source's folder and its folders
/// include, inc, headers, src and source are on its include path. Errors: CandidateError with the
/// compiler's output.
Compiled compile(const std::filesystem::path& source, const std::filesystem::path& to,
                 const RunOptions& options);

/// A shell command that builds something.
struct BuildWords {
  std::string words;
  std::string shown;  ///< The command's name in errors.
  /// Whether to copy a file that the command made; empty: copy all.
  std::function<bool(const std::filesystem::path& file)> keeps = {};
  std::string* said = nullptr;  ///< Gets the output of a command that fails, longer than in errors.
};

/// Runs a shell command in a copy of a folder, with the Java adapter added, sandboxed like a
/// candidate. Copies the resulting files, but no links, with their times to the folder `to`.
/// Errors: CandidateError with the command's output.
void build(const std::filesystem::path& folder, const BuildWords& words,
           const std::filesystem::path& to, const RunOptions& options);

}  // namespace raycheck::tools
