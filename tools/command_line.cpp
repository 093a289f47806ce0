#include "tools/command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include "tools/arguments.h"
#include "tools/commands.h"
#include "tools/report/version.h"

namespace raycheck::tools {

int run_command_line(int argc, char** argv) {
  CLI::App app{"raycheck: an exact reference for camera rays and ray-sphere intersections"};
  app.set_version_flag("--version", std::string(kVersion));
  app.require_subcommand(1);
  const std::vector<Command> commands = {
#define RAYCHECK_ADD(name) add_##name(app),
      RAYCHECK_COMMANDS(RAYCHECK_ADD)
#undef RAYCHECK_ADD
  };
  const std::string first = argc > 1 ? argv[1] : "";
  const bool is_command =
      std::any_of(commands.begin(), commands.end(),
                  [&](const Command& command) { return command.app->get_name() == first; });
  if (!first.empty() && first.front() != '-' && !is_command) {
    std::string known;
    for (const Command& command : commands) {
      known += (known.empty() ? "" : ", ") + command.app->get_name();
    }
    print_error(
        fmt::format("raycheck: there is no command '{}'; the commands are {}\n", first, known));
    return kExitBadInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kExitNothingFound : kExitBadInput;
  }
  try {
    const auto chosen = std::find_if(commands.begin(), commands.end(),
                                     [](const Command& command) { return command.app->parsed(); });
    return chosen->run();
  } catch (const std::exception& error) {
    print_error(fmt::format("raycheck: {}\n", error.what()));
    return kExitBadInput;
  }
}

}  // namespace raycheck::tools
