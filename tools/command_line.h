#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tools/commands.h"

namespace raycheck::tools {

/// A linked command with its options.
struct Command {
  CLI::App* app;
  CommandRun run;
};

/// Describes raycheck, and adds all commands to it; linked ones get their options.
std::vector<Command> make_program(CLI::App& program, std::span<const LinkedCommand> linked);

/// A program: reads its arguments, prints its report, returns its exit code.
int run_command_line(int argc, char** argv, std::span<const LinkedCommand> linked);

}  // namespace raycheck::tools
