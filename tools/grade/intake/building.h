#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tools/external/locate.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/grade/store/store.h"

namespace raycheck::tools {

/// Placeholder in BuildAttempt::program for the executable that the build makes.
inline constexpr std::string_view kMade = "{made}";

/// A way to build a submission.
struct BuildAttempt {
  std::string what;   ///< "its Makefile", "its sources"
  std::string shown;  ///< The command as shown to users: "make", "g++ -O2 rt.cpp".
  /// The shell commands run in a copy of the folder: first `repairs`, which remove and repair
  /// files, then `words`, which build. Empty words: nothing to build.
  std::string repairs, words;
  std::string program;  ///< Its command line; kMade for the executable that was made.
  /// Likely names of the executable, best first.
  std::vector<std::string> made = {};
  std::vector<std::string> notes = {};
  /// The Java class that a build may make instead of an executable: "de.uni.Main"; or empty.
  std::string main_class = {};
  bool only_after_failure = false;  ///< Tried only if the attempt before it fails.
};

/// Ways to build a submission, best first; if there are none, the reason.
struct BuildPlan {
  std::vector<BuildAttempt> attempts;
  std::string why_none;
};

/// How a submission's files can be built: by its Makefile or CMakeLists.txt; else C and C++, Java,
/// JavaScript, Python, in this order; else a program that was built before, or a script.
BuildPlan build_plan(const HandedInFiles& files);

/// The likeliest Java class with a main(), with its package; empty: there is no such class.
std::string java_main_class(const HandedInFiles& files);

/// The command line of a Java class, with a folder and jars on the class path.
std::string java_words(const std::string& folder, const std::vector<std::string>& jars,
                       const std::string& main_class);

/// Parts of build_plan(); each appends its ways.
void plan_make(const HandedInFiles& files, BuildPlan& plan);
void plan_cmake(const HandedInFiles& files, BuildPlan& plan);
void plan_c_family(const HandedInFiles& files, BuildPlan& plan);

/// Whether a file is a Linux program or library (ELF), or an executable for this machine.
bool is_elf(std::string_view text);
bool is_program_here(std::string_view text);

/// A submission before it is built.
struct Unbuilt {
  const Form& form;
  const std::string& file;              ///< The file by which the form fits.
  const CandidateSpec& program;         ///< The form's candidate, with {file} replaced.
  const std::filesystem::path& folder;  ///< A copy of the submission, with these files.
  const HandedInFiles& files;
  std::string contents;  ///< Their digest.
  std::size_t way = 0;   ///< The first of the ways to build it that is tried.
};

bool needs_building(const Unbuilt& submission);

/// Builds a submission in the empty folder `to`: by the form's command, in the first way that works
/// from `way` on, or as a library of functions. Errors: CandidateError with the compiler's output,
/// or with the output of every way.
Built build_submission(const Unbuilt& submission, const std::filesystem::path& to,
                       const RunOptions& options);

/// A digest of everything that a build depends on: files, commands, compilers, raycheck's version.
std::string build_key(const Unbuilt& submission, const Layers& layers);

}  // namespace raycheck::tools
