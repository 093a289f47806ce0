#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace raycheck::tools {

/// Splits a text at spaces and line ends.
std::vector<std::string> words_of(const std::string& text);

/// A process, as shown in /proc.
struct ProcessState {
  pid_t pid = 0, parent = 0;
  bool is_dead = false;    ///< Whether it is a zombie.
  double cpu_seconds = 0;  ///< Its CPU time, including that of children that it has reaped.
  std::uint64_t threads = 0;
  std::uint64_t memory = 0;  ///< Its physical memory in bytes, including shared memory.
};

/// A process and all its living descendants. Orphans belong to the nearest ancestor that adopts
/// them. `computed` receives their CPU time in seconds, including that of dead descendants and
/// reaped children.
std::vector<ProcessState> process_tree(pid_t root, double* computed = nullptr);

/// Whether a thread of these processes is runnable or waits for a disk. A thread that waits for its
/// own child does not count.
bool want_to_run(const std::vector<ProcessState>& processes);

/// Physical memory of several processes together, in bytes.
struct MemoryUse {
  std::uint64_t own = 0;     ///< Memory that is not shared, including programs and mapped files.
  std::uint64_t shared = 0;  ///< Shared memory.
};

/// The memory of these processes; memory that several of them share counts once.
MemoryUse memory_together(const std::vector<ProcessState>& processes);

/// A killed process that has not ended after this time never will, even on a busy machine.
inline constexpr std::chrono::seconds kMostEnding{20};

/// Kills all descendants of this process until none is left. False if some still run after
/// kMostEnding. Domain: this process adopts orphans, and has no other children to wait for.
bool end_children();

/// Ends a supervisor (a child of this process that kills its descendants on SIGTERM) and waits for
/// it, at most twice kMostEnding. False if the supervisor was killed, by this function or before,
/// so that descendants may be left.
bool end_supervised(pid_t supervisor);

}  // namespace raycheck::tools
