#include "tools/manual/manual.h"

#include "tools/manual/completions.h"
#include "tools/manual/man_page.h"

namespace raycheck::tools {

std::vector<ManualFile> manual_files(const ManualCommand& program, const std::string& version,
                                     std::span<const ManualCommand> commands) {
  std::vector<ManualFile> files = {
      {"man/man1/raycheck.1", program_page(program, version, commands)},
      {"bash-completion/completions/raycheck", bash_completion(program, commands)},
      {"zsh/vendor-completions/_raycheck", zsh_completion(program, commands)},
      {"fish/vendor_completions.d/raycheck.fish", fish_completion(program, commands)}};
  for (const ManualCommand& command : commands) {
    files.push_back({"man/man1/raycheck-" + command.name + ".1", command_page(command, version)});
  }
  return files;
}

}  // namespace raycheck::tools
