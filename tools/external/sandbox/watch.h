#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "tools/external/sandbox/file_tree.h"
#include "tools/external/sandbox/launch.h"
#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tools {

/// What is left to the machine and the judge: candidates are stopped when there is less.
inline constexpr std::uint64_t kMemoryReserve = std::uint64_t{384} << 20;
inline constexpr std::uint64_t kDiskReserve = std::uint64_t{256} << 20;

/// A program that waits more than it computes may take this many times its limit in wall time; one
/// that only waits, its limit once; each at least the seconds below. Time in which it could run but
/// the machine runs others counts this many times less.
inline constexpr double kBackstop = 10, kLeastBackstop = 1;

class ControlGroup;

/// The message for a program that meets its memory limit: "was stopped: it uses more than 4096 MiB
/// of memory (memory_mib)".
std::string memory_words(const Limits& limits);

/// "the machine has less than 256 MiB of disk left"; empty if it has enough.
std::string lack_of_room(const std::filesystem::path& folder);

/// Why something was stopped.
struct Stop {
  FailureKind kind;
  std::string words;
};

/// Checks from time to time what a process and everything it started use together. Their time is
/// CPU time; those that only wait are stopped as well, but much later.
class Watch {
 public:
  /// `group`: their control group, which measures them exactly; or null. `has_neighbours`: other
  /// candidates run beside it, so that merely waiting may not be its own fault.
  Watch(pid_t root, std::filesystem::path folder, const Limits& limits, const ControlGroup* group,
        bool has_neighbours);
  /// Starts a new time limit.
  void restart();
  /// Cheap if the next check is not due. `doing`: "gave no reply".
  std::optional<Stop> look(const char* doing);
  /// Notes that it has said something: until then it may have waited to be read.
  void hear() { ran_ = Clock::now(); }
  /// Notes that it has ended, and the CPU time of it and of all children that it waited for.
  void end(double cpu_seconds);
  /// Of its time, in seconds: what it computed since the last restart, as far as is known, and at
  /// least a tenth (kBackstop) of what it waited. A program stopped for its time has taken its
  /// limit.
  double taken() const;
  /// The longest wait until the next check.
  std::chrono::milliseconds until_next() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<ProcessState> count();
  std::optional<Stop> time_up(const char* doing, const std::vector<ProcessState>& tree);
  std::optional<Stop> excess(const std::vector<ProcessState>& tree);
  /// How long it has waited since the last restart, in seconds.
  double waited() const;

  pid_t root_;
  std::filesystem::path folder_;
  const Limits& limits_;
  const ControlGroup* group_;
  bool has_neighbours_;
  Clock::duration interval_;
  Clock::time_point looked_, ran_, next_, next_at_files_;
  double computed_ = 0;   ///< In seconds, as far as known; including its layers.
  double before_ = 0;     ///< The same at the last restart.
  double until_ran_ = 0;  ///< And when it ran last.
  double waited_ = 0;     ///< In seconds, from the last restart to the last check.
  bool is_up_ = false;
  DiskUse files_;  ///< When they were last checked.
};

}  // namespace raycheck::tools
