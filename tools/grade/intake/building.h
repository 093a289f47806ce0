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

/// Stands for `{program}` of a built candidate: the executable that was made.
inline constexpr std::string_view kMade = "{made}";

/// A way to build a submission.
struct BuildAttempt {
  std::string what;   ///< "its Makefile", "its sources"
  std::string shown;  ///< What is run, for who reads of it: "make", "g++ -O2 rt.cpp".
  /// The shell words, run in a copy of the folder: what removes and repairs files, then what
  /// builds; empty: nothing to build.
  std::string repairs, words;
  std::string program;  ///< Its command line; kMade for the executable that was made.
  /// Likely names of the executable, best first.
  std::vector<std::string> made = {};
  std::vector<std::string> notes = {};
  /// That a build may make in place of an executable: "de.uni.Main"; empty: no Java.
  std::string main_class = {};
  bool only_after_failure = false;  ///< Another try at what the attempt before it builds.
};

/// Ways to build a submission, best first, or why there is none.
struct BuildPlan {
  std::vector<BuildAttempt> attempts;
  std::string why_none;
};

/// How a submission's files can be built: by its Makefile or CMakeLists.txt; else C and C++, Java,
/// JavaScript, Python, in this order; else a program that was built before, or a script.
BuildPlan build_plan(const HandedInFiles& files);

/// The class of the likeliest main of Java, with its package; empty: there is none.
std::string java_main_class(const HandedInFiles& files);

/// What starts a class: with what lies in a folder and in jars, by their paths.
std::string java_words(const std::string& folder, const std::vector<std::string>& jars,
                       const std::string& main_class);

/// Parts of build_plan(); each adds its ways after those before it.
void plan_make(const HandedInFiles& files, BuildPlan& plan);
void plan_cmake(const HandedInFiles& files, BuildPlan& plan);
void plan_c_family(const HandedInFiles& files, BuildPlan& plan);

/// Whether a file is a program or library of Linux (ELF), or one of this machine that can be
/// started.
bool is_elf(std::string_view text);
bool is_program_here(std::string_view text);

/// A submission before it is built.
struct Unbuilt {
  const Form& form;
  const std::string& file;              ///< What says that the form fits.
  const CandidateSpec& program;         ///< What the form makes of it.
  const std::filesystem::path& folder;  ///< A copy of the submission, with these files.
  const HandedInFiles& files;
  std::string contents;  ///< Their digest.
  std::size_t way = 0;   ///< Of the ways to build it, the first that is tried.
};

bool needs_building(const Unbuilt& submission);

/// Builds a submission in the empty folder `to`: by the form's words, in the first way that works
/// from `way` on, or as a library of functions. Errors: CandidateError with what a compiler said,
/// of several ways with what each did.
Built build_submission(const Unbuilt& submission, const std::filesystem::path& to,
                       const RunOptions& options);

/// A digest of all that what is built depends on: the files, what is run on them, compilers, and
/// raycheck's version.
std::string build_key(const Unbuilt& submission, const Layers& layers);

}  // namespace raycheck::tools
