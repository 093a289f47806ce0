#ifndef RAYCHECK_TOOLS_COMMANDS_H_
#define RAYCHECK_TOOLS_COMMANDS_H_

// The program's commands, each in the file of its name. Internal to the command line.

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace raycheck::tools {

/// A command: `app` holds its options, and run() does what they ask for and returns the exit code.
struct Command {
  CLI::App* app;
  std::function<int()> run;
};

/// The commands, in the order of --help: NAME is that of tools/NAME/NAME_command.cpp, where
/// add_NAME adds it to the program.
#define RAYCHECK_COMMANDS(ROW) \
  ROW(check)                   \
  ROW(properties)              \
  ROW(explain)                 \
  ROW(stress)                  \
  ROW(tradeoff)                \
  ROW(worst)                   \
  ROW(image)                   \
  ROW(view)                    \
  ROW(plan)                    \
  ROW(grade)                   \
  ROW(try)                     \
  ROW(rubric)                  \
  ROW(generate)                \
  ROW(verify)                  \
  ROW(list)

#define RAYCHECK_DECLARE(name) Command add_##name(CLI::App& program);
RAYCHECK_COMMANDS(RAYCHECK_DECLARE)
#undef RAYCHECK_DECLARE

/// Says what the program is, and adds all commands to it.
std::vector<Command> make_program(CLI::App& program);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_COMMANDS_H_
