#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace raycheck::tools {

/// What lies between spaces and line ends.
std::vector<std::string> words_of(const std::string& text);

/// A process as shown in /proc.
struct ProcessState {
  pid_t pid = 0, parent = 0;
  bool is_dead = false;    ///< It only waits to be reaped.
  double cpu_seconds = 0;  ///< Of itself, and of children it has reaped.
  std::uint64_t threads = 0;
  std::uint64_t memory = 0;  ///< Physical memory in bytes, including what is shared.
};

/// A process and all its living descendants. What a process leaves behind when it ends belongs to
/// its nearest ancestor that takes orphans.
/// `computed`: what they have computed until now, in seconds, with those of them that are dead or
/// that they have waited for.
std::vector<ProcessState> process_tree(pid_t root, double* computed = nullptr);

/// Whether a thread of these could run if a processor were free, or waits for a disk. A process
/// that waits for its own child does neither.
bool want_to_run(const std::vector<ProcessState>& processes);

/// What processes have in memory together, in bytes.
struct MemoryUse {
  std::uint64_t own = 0;     ///< Including programs and files.
  std::uint64_t shared = 0;  ///< Shared memory.
};

/// Memory that several share counts once.
MemoryUse memory_together(const std::vector<ProcessState>& processes);

/// A killed process has ended after this time, however busy the machine is, or it never ends.
inline constexpr std::chrono::seconds kMostEnding{20};

/// Kills all descendants of this process until none is left. False if some still run after
/// kMostEnding. Domain: this process takes orphans and waits for nobody else.
bool end_children();

/// Ends a supervisor, a child of this process that ends its descendants on SIGTERM, and waits for
/// it, at most twice kMostEnding. False if it was killed before it had done so, or had to be.
bool end_supervised(pid_t supervisor);

}  // namespace raycheck::tools
