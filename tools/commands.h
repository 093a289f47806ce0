#ifndef RAYCHECK_TOOLS_COMMANDS_H_
#define RAYCHECK_TOOLS_COMMANDS_H_

// The program's commands, each in the file of its name. Internal to the command line.

#include <CLI/CLI.hpp>
#include <functional>

namespace raycheck::tools {

/// A command: `app` holds its options, and run() does what they ask for and returns the exit code.
struct Command {
  CLI::App* app;
  std::function<int()> run;
};

Command add_check(CLI::App& program);
Command add_properties(CLI::App& program);
Command add_explain(CLI::App& program);
Command add_stress(CLI::App& program);
Command add_tradeoff(CLI::App& program);
Command add_worst(CLI::App& program);
Command add_image(CLI::App& program);
Command add_plan(CLI::App& program);
Command add_grade(CLI::App& program);
Command add_generate(CLI::App& program);
Command add_verify(CLI::App& program);
Command add_list(CLI::App& program);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_COMMANDS_H_
