#pragma once

#include <filesystem>
#include <memory>
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

/// Ways to build a submission, best first: by its Makefile or CMakeLists.txt; as C and C++, Java,
/// JavaScript or Python; as a program that is already built, or a script. Errors: CandidateError if
/// there are none.
std::vector<BuildAttempt> build_plan(const HandedInFiles& files);

/// The likeliest Java class with a main(), with its package; empty if there is none.
std::string java_main_class(const HandedInFiles& files);

/// The command line of a Java class, with a folder and jars on the class path.
std::string java_words(const std::string& folder, const std::vector<std::string>& jars,
                       const std::string& main_class);

/// Parts of build_plan(); each appends its ways to build.
void plan_recipes(const HandedInFiles& files, std::vector<BuildAttempt>& plan);
void plan_c_family(const HandedInFiles& files, std::vector<BuildAttempt>& plan);

/// is_elf(): whether a file is a Linux program or library. is_program_here(): whether it is an
/// executable for this machine.
bool is_elf(std::string_view text);
bool is_program_here(std::string_view text);

/// A copy of a submission, which its program may read.
struct Sources {
  std::shared_ptr<const PrivateFolder> folder;
  HandedInFiles files = {};
  std::string digest = {};  ///< Of the submitted files: names, contents, executability; of folders.
  std::vector<OpaqueFile> opaque = {};
  std::shared_ptr<const StartingFolder> start = {};  ///< The folder in which a renderer runs.
};

/// The form that fits a submission.
struct FittingForm {
  const Form& form;
  std::string file;       ///< The file by which it fits.
  CandidateSpec program;  ///< As in the form, with {file} replaced.

  bool needs_building() const {
    return !form.build.empty() || program.kind == CandidateKind::kSource;
  }
};

/// Everything that a submission's programs are built from, and run with.
struct Intake {
  Sources sources;
  FittingForm fitting;
  RunOptions options;
  const Rubric& rubric;
  Store* store;  ///< Null: nothing is stored.
};

/// Lays a form's adapter, if it has one, into a submission's folder, in place of a file of its name
/// and of copies of raycheck's own files for Python, JavaScript and Java.
void lay_adapter(const Form& form, const std::filesystem::path& folder);

/// Builds a submission in the empty folder `to`: by the form's command; if that is "auto", in the
/// first way that works, beginning with number `way`; or as a library of functions. Errors:
/// CandidateError with the compiler's output, or with the output of every way.
Built build_submission(const Intake& intake, std::size_t way, const std::filesystem::path& to);

/// A digest of everything that a build depends on: files, commands, compilers, raycheck's version.
std::string build_key(const Intake& intake, std::size_t way);

}  // namespace raycheck::tools
