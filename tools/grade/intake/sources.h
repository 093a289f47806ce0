#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/grade/intake/handed_in.h"

namespace raycheck::tools {

/// Files' names as words of a shell.
std::string shell_words(const std::vector<std::string>& names);

/// A file's name as one of a candidate's words, which are split where no quotes are.
std::string candidate_word(const std::string& name);

/// In small letters, those of ASCII.
std::string lower_case(std::string text);

/// The folder of a path, "" at the top; its last part; its ending as ".cpp", in small letters
/// but for ".C".
std::string folder_of(const std::string& path);
std::string base_of(const std::string& path);
std::string ending_of(const std::string& path);

bool is_cpp(const std::string& path);
bool is_c_or_cpp(const std::string& path);
/// A source or a header of C or C++.
bool is_c_family(const std::string& path);

/// A text without comments of C, C++, Java and JavaScript; as many lines.
std::string without_comments(std::string_view text);

/// Whether C or C++ says `int main(`.
bool defines_main(std::string_view text);

/// An #include of a text.
struct IncludeLine {
  int line = 0;  ///< From 1.
  std::string name;
  bool is_quoted = false;
};
std::vector<IncludeLine> includes_of(std::string_view text);

/// The folders that hold someone else's headers, Eigen and glm, which are no sources to compile.
struct Vendored {
  std::vector<std::string> include;  ///< To look for headers in: what has Eigen/Dense below it.
  std::vector<std::string> folders;  ///< Theirs as a whole.
  bool has(const std::string& path) const;
};
Vendored vendored_in(const HandedInFiles& files);

/// The names for which `holds`, of sources that are the submission's own: those of tests, examples
/// and builds only where there are no others.
template <class Holds>
std::vector<std::string> own_sources(const HandedInFiles& files, const Vendored& vendored,
                                     const Holds& holds);

/// Whether it lies below a folder of builds, tests or examples.
bool is_aside(const std::string& path);

/// How likely a file of this name starts a renderer, 0 for rt and raytracer; lower is likelier.
/// kHardlyARenderer for what is called test, backup, example and the like.
inline constexpr int kHardlyARenderer = 4;
int likelihood_rank(const std::string& path);

/// The names in the order in which a renderer is likely called so: main, rt, raytracer first, tests
/// last, then those closer to the top.
void sort_by_likelihood(std::vector<std::string>& names);

/// An #include that names no file of the submission, with what it means, or one that is missing.
struct IncludeRepair {
  std::string file;
  int line = 0;         ///< From 1; 0: there is none.
  std::string name;     ///< As it stands: "../eigen/Eigen/Dense".
  std::string instead;  ///< "<Eigen/Dense>", "\"../vec.h\""
  std::string note() const;
};

/// Includes of the submission's own files that lead nowhere where the file is known: of Eigen or
/// glm in a folder that was not handed in, with backslashes, in capitals that the file does not
/// have, or of the one file of that name in another folder. `include`: folders that are searched.
std::vector<IncludeRepair> include_repairs(const HandedInFiles& files, const Vendored& vendored,
                                           const std::vector<std::string>& include);

/// Those that GCC names in what it said: "did you forget to '#include <tuple>'?"
std::vector<IncludeRepair> missing_includes(const HandedInFiles& files, const std::string& said);

/// Shell words that make them in a copy of the submission; empty where there are none.
std::string repair_words(const std::vector<IncludeRepair>& repairs);

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

}  // namespace raycheck::tools
