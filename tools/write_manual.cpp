// write_manual FOLDER: man pages and completions, made from the program's own options, go below a
// folder as they are installed below share.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/command_line.h"
#include "tools/commands.h"
#include "tools/manual/manual.h"
#include "tools/report/version.h"

namespace raycheck::tools {
namespace {

ManualOption manual_of(const CLI::Option& option) {
  ManualOption manual;
  manual.is_positional = option.get_positional();
  if (manual.is_positional) {
    manual.names = {option.get_name(true, false)};
  } else {
    for (const std::string& name : option.get_snames()) manual.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) manual.names.push_back("--" + name);
  }
  if (option.get_items_expected_max() > 0) manual.value = option.get_type_name();
  manual.text = option.get_description();
  return manual;
}

ManualCommand manual_of(const CLI::App& command) {
  ManualCommand manual{command.get_name(), command.get_description(), {}};
  for (const CLI::Option* option : command.get_options()) {
    manual.options.push_back(manual_of(*option));
  }
  return manual;
}

std::vector<ManualFile> files() {
  CLI::App app;
  const std::vector<Command> added = make_program(app, kAllCommands);
  std::vector<ManualCommand> commands;
  for (const Command& command : added) commands.push_back(manual_of(*command.app));
  return manual_files(manual_of(app), std::string(kVersion), commands);
}

void write(const std::filesystem::path& folder) {
  for (const ManualFile& file : files()) {
    const std::filesystem::path path = folder / file.path;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << file.text;
    if (!std::ifstream(path)) throw std::runtime_error(path.string() + ": cannot be written");
  }
}

}  // namespace
}  // namespace raycheck::tools

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("usage: write_manual FOLDER");
    raycheck::tools::write(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_manual: %s\n", error.what());
    return 2;
  }
}
