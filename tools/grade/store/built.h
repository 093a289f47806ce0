#pragma once

#include <string>
#include <vector>

namespace raycheck::tools {

/// What was made of a submission.
struct Built {
  /// What starts it, or the library's name, from its folder; of several programs likelier ones
  /// first.
  std::vector<std::string> programs = {""};
  std::string words = {};  ///< The shell words that built it; empty: nothing was to build.
  /// What who reads the grade should know: "its Makefile failed; built from its sources".
  std::vector<std::string> notes = {};
};

}  // namespace raycheck::tools
