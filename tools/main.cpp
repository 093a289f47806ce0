// raycheck: starts the program that contains the command.

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

#include "tools/commands.h"

namespace {

namespace fs = std::filesystem;

/// Finds a program: beside this one in a build folder, below libexec in an installation.
fs::path found(const fs::path& folder, const std::string& program) {
  const fs::path beside = folder / program;
  std::error_code error;
  return fs::exists(beside, error) ? beside
                                   : folder.parent_path() / "libexec" / "raycheck" / program;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace raycheck::tools;
  const CommandRow* const row = argc > 1 ? find_command(argv[1]) : nullptr;
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const std::string program(row != nullptr ? row->program : kAnswersForAll);
  const fs::path path = found(self.parent_path(), program);
  execv(path.c_str(), argv);
  std::fprintf(stderr, "raycheck: %s: %s; build or install the program %s with raycheck\n",
               path.c_str(), std::strerror(errno), program.c_str());
  return kExitBadInput;
}
