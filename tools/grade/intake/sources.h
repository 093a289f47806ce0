#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tools/grade/intake/handed_in.h"

namespace raycheck::tools {

/// File names quoted for a shell.
std::string shell_words(const std::vector<std::string>& names);

/// A file name as a word of a candidate's command line, quoted if needed.
std::string candidate_word(const std::string& name);

template <class Names>
bool is_one_of(const Names& names, std::string_view name) {
  return std::ranges::find(names, name) != std::end(names);
}

/// The folder of a path ("" at the top); its last component; its extension (".cpp"), in lower case
/// except ".C".
std::string folder_of(const std::string& path);
std::string base_of(const std::string& path);
std::string ending_of(const std::string& path);

bool is_cpp(const std::string& path);
bool is_c_or_cpp(const std::string& path);
/// A source or a header of C or C++.
bool is_c_family(const std::string& path);

/// A C, C++, Java or JavaScript text without its comments; line numbers stay the same.
std::string without_comments(std::string_view text);

/// The tokens of a C, C++ or Java text: names with their dots, and every other character except
/// spaces.
std::vector<std::string_view> words_of_code(std::string_view text);

/// Whether C or C++ source contains `int main(`.
bool defines_main(std::string_view text);

/// An #include in a text.
struct IncludeLine {
  int line = 0;  ///< From 1.
  std::string name;
  bool is_quoted = false;
};
std::vector<IncludeLine> includes_of(std::string_view text);

/// The folders of the libraries Eigen and glm in a submission; their files are not sources to
/// compile.
struct Vendored {
  /// Folders for the include path: those that contain Eigen/Dense or the like.
  std::vector<std::string> include;
  std::vector<std::string> folders;  ///< The libraries' whole folders.
  bool has(const std::string& path) const;
};
Vendored vendored_in(const HandedInFiles& files);

/// Whether a path lies in a folder for builds, tests or examples.
bool is_aside(const std::string& path);

/// The submission's files for which `holds` is true, without library headers. Files in folders for
/// tests, examples and builds are included only if there are no others.
template <class Holds>
std::vector<std::string> own_sources(const HandedInFiles& files, const Vendored& vendored,
                                     const Holds& holds) {
  std::vector<std::string> own, aside;
  for (const auto& [name, file] : files) {
    if (vendored.has(name) || !holds(name, file)) continue;
    (is_aside(name) ? aside : own).push_back(name);
  }
  return own.empty() ? aside : own;
}

/// A rank of how likely a file with this name starts a renderer; lower is likelier. It is 0 for rt
/// and raytracer, kHardlyARenderer for names like test, backup, example.
inline constexpr int kHardlyARenderer = 4;
int likelihood_rank(const std::string& path);

/// Sorts names by likelihood_rank(); of equal ranks, names closer to the top come first.
void sort_by_likelihood(std::vector<std::string>& names);

/// A repair: replaces an #include of a file that does not exist.
struct IncludeRepair {
  std::string file;
  int line = 0;         ///< The line of the #include, from 1.
  std::string name;     ///< The name as written: "../eigen/Eigen/Dense".
  std::string instead;  ///< "<Eigen/Dense>", "\"../vec.h\""
  std::string note() const;
};

/// Repairs of broken includes in the submission's files whose target is known: Eigen or glm in a
/// folder that was not submitted, backslashes, wrong capitals, or the only file of that name in
/// another folder. `include`: the include path.
std::vector<IncludeRepair> include_repairs(const HandedInFiles& files, const Vendored& vendored,
                                           const std::vector<std::string>& include);

/// A shell command that applies repairs in a copy of the submission; empty if there are none.
std::string repair_words(const std::vector<IncludeRepair>& repairs);

/// What a compiler's output suggests to add to a build.
struct BuildHint {
  std::string words;  ///< A shell command to run before the build.
  std::string note;
};

/// In a command that compiles, the place of the options that hints add.
inline constexpr std::string_view kHintedOptions = "$also";

/// The hints in the output of GCC: #include lines and macros that a submitted file lacks, and, if
/// the build takes kHintedOptions, options.
std::vector<BuildHint> hints_in(const std::string& said, const HandedInFiles& files,
                                bool takes_options);

}  // namespace raycheck::tools
