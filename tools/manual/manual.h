#pragma once

#include <span>
#include <string>
#include <vector>

namespace raycheck::tools {

/// An option of a command, or what it takes without one.
struct ManualOption {
  std::vector<std::string> names;  ///< With their hyphens; of a positional its one name, "SCENE".
  bool is_positional = false;
  std::string value;  ///< What is given to it, "TEXT"; empty: nothing.
  std::string text;
};

/// A command, or the program itself with what it takes before one.
struct ManualCommand {
  std::string name;  ///< "check"
  std::string sentence;
  std::vector<ManualOption> options;
};

/// What is installed for people and shells, made of the program's own options.
struct ManualFile {
  std::string path;  ///< Below share: "man/man1/raycheck-check.1"
  std::string text;
};

/// Man pages of the program and each command, and completions for bash, zsh and fish.
std::vector<ManualFile> manual_files(const ManualCommand& program, const std::string& version,
                                     std::span<const ManualCommand> commands);

}  // namespace raycheck::tools
