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

/// Memory and disk reserved for the machine and raycheck. Candidates are stopped if less is left.
inline constexpr std::uint64_t kMemoryReserve = std::uint64_t{384} << 20;
inline constexpr std::uint64_t kDiskReserve = std::uint64_t{256} << 20;

/// The limit on CPU time also limits wall time: a program that mostly waits may take kBackstop
/// times its limit, an idle one its limit once, and both at least kLeastBackstop seconds. Wall time
/// in which the program is runnable counts only 1/kBackstop.
inline constexpr double kBackstop = 10, kLeastBackstop = 1;

class ControlGroup;

/// The message for a program that meets its memory limit: "was stopped: it uses more than 4096 MiB
/// of memory (memory_mib)".
std::string memory_words(const Limits& limits);

/// The message if memory or disk space runs short: "the machine has less than 256 MiB of disk
/// left"; empty if not.
std::string lack_of_room(const std::filesystem::path& folder);

/// Why a program was stopped.
struct Stop {
  FailureKind kind;
  std::string words;
};

/// Periodically checks the resources that a process and its descendants use together. Time limits
/// are in CPU time; processes that only wait are stopped, too, but later.
class Watch {
 public:
  /// `group`: their control group, which measures CPU time exactly; may be null. `has_neighbours`:
  /// whether other candidates run in parallel, so that waiting may not be the program's fault.
  Watch(pid_t root, std::filesystem::path folder, const Limits& limits, const ControlGroup* group,
        bool has_neighbours);
  /// Starts the time limit again.
  void restart();
  /// Makes a check if one is due; otherwise it is cheap. `doing` begins the message: "gave no
  /// reply".
  std::optional<Stop> look(const char* doing);
  /// To be called when output was read: before, the process may have been blocked by a full pipe.
  void hear() { ran_ = Clock::now(); }
  /// To be called when the process has ended, with its CPU time and that of its reaped children.
  void end(double cpu_seconds);
  /// The time charged since the last restart, in seconds: the CPU time at the last check, but at
  /// least 1/kBackstop of the waiting time. If it was stopped because of its time, the full limit.
  double taken() const;
  /// The time since the last restart in which no process could run, over the time limit, but at
  /// least 1: waiting for a busy machine does not count.
  double limits_waited() const;
  /// The longest wait until the next check.
  std::chrono::milliseconds until_next() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::vector<ProcessState> count();
  std::optional<Stop> time_up(const char* doing, const std::vector<ProcessState>& tree);
  std::optional<Stop> excess(const std::vector<ProcessState>& tree);
  /// Its waiting time since the last restart, in seconds.
  double waited() const;

  pid_t root_;
  std::filesystem::path folder_;
  const Limits& limits_;
  const ControlGroup* group_;
  bool has_neighbours_;
  Clock::duration interval_;
  Clock::time_point looked_, ran_, next_, next_at_files_;
  double computed_ = 0;   ///< CPU seconds at the last check, including those of its layers.
  double before_ = 0;     ///< CPU seconds at the last restart.
  double until_ran_ = 0;  ///< CPU seconds when it last ran.
  double waited_ = 0;     ///< In seconds, from the last restart to the last check.
  double slept_ = 0;      ///< The part of it in which no process could run.
  bool is_up_ = false;
  DiskUse files_;  ///< The disk use at its last check.
};

}  // namespace raycheck::tools
