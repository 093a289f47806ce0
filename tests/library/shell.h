#pragma once

#include <filesystem>
#include <string>

#include "tests/has.h"

namespace raycheck::tests {

struct Ended {
  int code = -1;
  std::string text;  ///< Of both its outputs.
};

/// Runs a command by the shell.
Ended shell(const std::string& command);

/// The text of a file; empty where there is none.
std::string text_of(const std::filesystem::path& path);

/// Builds an example of an installed tree in a folder, as its CMakeLists.txt says.
Ended build_example(const std::filesystem::path& prefix, const std::string& name,
                    const std::filesystem::path& to, const std::string& options = "");

}  // namespace raycheck::tests
