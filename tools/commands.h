#pragma once

// The commands, and the programs that contain them; `raycheck` starts these programs, as git does.
// CMake and ./run read the rows.

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace raycheck::tools {

/// Runs a command whose options are given; returns its exit code.
using CommandRun = std::function<int()>;

/// A command that is linked into this program.
struct LinkedCommand {
  std::string_view name;
  CommandRun (*add)(CLI::App& command);
};
/// A command with its options.
struct Command {
  CLI::App* app;
  CommandRun run;
};
/// Adds raycheck's description and all commands to `program`. Linked commands get their options.
std::vector<Command> make_program(CLI::App& program, std::span<const LinkedCommand> linked);
/// Parses a program's arguments, runs the command, prints its report and returns the exit code.
int run_command_line(int argc, char** argv, std::span<const LinkedCommand> linked);

// clang-format off
/// The commands, in the order of --help: NAME is that of tools/ROOM/NAME_command.cpp, where add_NAME
/// gives it its options, PROGRAM is the raycheck-PROGRAM that has it.
#define RAYCHECK_COMMANDS(ROW) \
  ROW(check, check, "Judge methods or your code on the rays of a scene")                           \
  ROW(properties, study, "Try the laws on random cases, and shrink cases that break them")         \
  ROW(explain, study, "Derive one ray step by step, exactly and by every method")                  \
  ROW(stress, study, "Judge each stage of methods separately, on cases of growing severity")       \
  ROW(tradeoff, study, "Compare methods by certified error and measured time on the same inputs")  \
  ROW(worst, study, "Search for the input on which a method's certified error is largest")         \
  ROW(merge, study, "Report on a campaign whose shards ran separately, on any machines")           \
  ROW(image, study, "Write the picture of a scene, with every pixel decided exactly")              \
  ROW(view, study, "Show a scene, its rays and where methods go wrong, in a page for a browser")   \
  ROW(plan, study, "Show which work a scene does not need, and measure the time that this saves")  \
  ROW(grade, grade, "Grade submissions by a rubric; without submissions, check the rubric")                  \
  ROW(try, grade, "Grade your own submission by a rubric, as your instructors will")               \
  ROW(rubric, grade, "Print or copy a rubric that comes with raycheck; without a name, list them") \
  ROW(new, study, "Write an adapter for your own code, to fill in")                                \
  ROW(list, study, "Show methods, laws, sources and conventions")
// clang-format on

#define RAYCHECK_DECLARE(name, program, sentence) CommandRun add_##name(CLI::App& command);
RAYCHECK_COMMANDS(RAYCHECK_DECLARE)
#undef RAYCHECK_DECLARE

struct CommandRow {
  std::string_view name, program, sentence;
};
inline constexpr CommandRow kCommands[] = {
#define RAYCHECK_ROW(name, program, sentence) {#name, "raycheck-" #program, sentence},
    RAYCHECK_COMMANDS(RAYCHECK_ROW)
#undef RAYCHECK_ROW
};

/// The row of a command; null if there is no such command.
constexpr const CommandRow* find_command(std::string_view name) {
  for (const CommandRow& row : kCommands) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

/// The program that answers --help, --version and unknown commands.
inline constexpr std::string_view kAnswersForAll = find_command("check")->program;

// The exit codes of every command.
inline constexpr int kExitNothingFound = 0;
inline constexpr int kExitDiscrepancy = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitNothingChecked = 4;
/// A bug in raycheck: EX_SOFTWARE of sysexits.h.
inline constexpr int kExitInternal = 70;
/// Plus the number of the signal that interrupted the command, or of SIGPIPE if the output pipe is
/// closed.
inline constexpr int kExitOfSignal = 128;
/// `found`: a defect or another failure; `checked`: enough was judged to exclude one.
int exit_code(bool was_interrupted, bool found, bool checked);

}  // namespace raycheck::tools
