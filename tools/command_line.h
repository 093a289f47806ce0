#ifndef RAYCHECK_TOOLS_COMMAND_LINE_H_
#define RAYCHECK_TOOLS_COMMAND_LINE_H_

namespace raycheck::tools {

// What the program's exit codes mean.
inline constexpr int kExitNothingFound = 0;
inline constexpr int kExitDiscrepancy = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitNothingChecked = 4;
/// And the signal: of one that interrupted it, and of SIGPIPE where nobody reads what it prints.
inline constexpr int kExitOfSignal = 128;

/// The program: reads its arguments, prints its report, returns its exit code.
int run_command_line(int argc, char** argv);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_COMMAND_LINE_H_
