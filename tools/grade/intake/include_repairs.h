#pragma once

#include <string>
#include <vector>

#include "tools/grade/intake/sources.h"

namespace raycheck::tools {

/// An #include that names no file of the submission, and what it means; or one that is missing.
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

}  // namespace raycheck::tools
