#pragma once

namespace raycheck::tools {

// What the exit codes of every command mean.
inline constexpr int kExitNothingFound = 0;
inline constexpr int kExitDiscrepancy = 1;
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitNothingChecked = 4;
/// And the signal: of one that interrupted it, and of SIGPIPE where nobody reads what it prints.
inline constexpr int kExitOfSignal = 128;

}  // namespace raycheck::tools
