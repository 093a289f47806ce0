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

/// A placeholder in BuildAttempt::program for the executable that the build makes.
inline constexpr std::string_view kMade = "{made}";

/// A way to build a submission.
struct BuildAttempt {
  std::string what;   ///< "its Makefile", "its sources"
  std::string shown;  ///< The command for messages: "make", "g++ -O2 rt.cpp".
  /// The shell commands that are run in a copy of the folder: first `repairs`, which removes and
  /// repairs files, then `words`, which builds. If `words` is empty, there is nothing to build.
  std::string repairs, words;
  /// The program's command line; kMade stands for the executable that was made.
  std::string program;
  /// Likely names of the executable, best first.
  std::vector<std::string> made = {};
  std::vector<std::string> notes = {};
  /// The Java class that a build may make instead of an executable: "de.uni.Main"; or empty.
  std::string main_class = {};
  bool only_after_failure = false;  ///< Whether it is tried only if the attempt before it fails.
};

/// Ways to build a submission, best first; if there are none, the reason.
struct BuildPlan {
  std::vector<BuildAttempt> attempts;
  std::string why_none;
};

/// Ways to build a submission, in this order: by its Makefile or CMakeLists.txt; as C and C++,
/// Java, JavaScript or Python; as a program that is already built, or a script.
BuildPlan build_plan(const HandedInFiles& files);

/// The likeliest Java class with a main(), with its package; empty if there is none.
std::string java_main_class(const HandedInFiles& files);

/// The command line of a Java class, with a folder and jars on the class path.
std::string java_words(const std::string& folder, const std::vector<std::string>& jars,
                       const std::string& main_class);

/// Parts of build_plan(); each appends its ways to build.
void plan_make(const HandedInFiles& files, BuildPlan& plan);
void plan_cmake(const HandedInFiles& files, BuildPlan& plan);
void plan_c_family(const HandedInFiles& files, BuildPlan& plan);

/// is_elf(): whether a file is a Linux program or library. is_program_here(): whether it is an
/// executable for this machine.
bool is_elf(std::string_view text);
bool is_program_here(std::string_view text);

/// A submission before it is built.
struct Unbuilt {
  const Form& form;
  const std::string& file;              ///< The file by which the form fits.
  const CandidateSpec& program;         ///< The form's candidate, with {file} replaced by `file`.
  const std::filesystem::path& folder;  ///< A copy of the submission, with the files below.
  const HandedInFiles& files;
  std::string contents;  ///< The digest of the files.
  std::size_t way = 0;   ///< The index of the way to build it that is tried first.
};

/// Lays a form's adapter, if it has one, into a submission's folder, in place of a file of its name
/// and of copies of raycheck's own files for Python, JavaScript and Java.
void lay_adapter(const Form& form, const std::filesystem::path& folder);

bool needs_building(const Unbuilt& submission);

/// Builds a submission in the empty folder `to`: by the form's command; if that is "auto", in the
/// first way that works, beginning with number `way`; or as a library of functions. Errors:
/// CandidateError with the compiler's output, or with the output of every way.
Built build_submission(const Unbuilt& submission, const std::filesystem::path& to,
                       const RunOptions& options);

/// A digest of everything that a build depends on: files, commands, compilers, raycheck's version.
std::string build_key(const Unbuilt& submission, const Layers& layers);

}  // namespace raycheck::tools
