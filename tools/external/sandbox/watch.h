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

/// What the machine keeps for itself and for the judge: what runs when there is less is stopped.
inline constexpr std::uint64_t kMemoryReserve = std::uint64_t{384} << 20;
inline constexpr std::uint64_t kDiskReserve = std::uint64_t{256} << 20;

/// Who waits more than he computes has so many times his limit of time that passes; who does
/// nothing but wait, his limit once. Neither has less than so many seconds. Time in which he wants
/// to run, and the machine lets others, passes as many times slower.
inline constexpr double kBackstop = 10, kLeastBackstop = 1;

class ControlGroup;

/// What a program that meets its limit on memory is told: "was stopped: it uses more than 4096 MiB
/// of memory (memory_mib)".
std::string memory_words(const Limits& limits);

/// "the machine has less than 256 MiB of disk left below /tmp"; empty where it has room.
std::string lack_of_room(const std::filesystem::path& folder);

/// Why something was stopped.
struct Stop {
  FailureKind kind;
  std::string words;
};

/// Looks now and then at a process and all that it started: what they use together. Their time is
/// what they compute; those who wait are stopped, too, though much later.
class Watch {
 public:
  /// `group`: theirs, where they have one, which counts them exactly; else null. `has_neighbours`:
  /// other candidates run beside it, so that it is no fault of its own where it only waits.
  Watch(pid_t root, std::filesystem::path folder, const Limits& limits, const ControlGroup* group,
        bool has_neighbours);
  /// Something begins: its time.
  void restart();
  /// Cheap where it is too early for the next look. `doing`: "gave no reply".
  std::optional<Stop> look(const char* doing);
  /// It has said something: until then it may have waited to be heard.
  void hear() { ran_ = Clock::now(); }
  /// It has ended, and it and all that it waited for have computed so much.
  void end(double cpu_seconds);
  /// Of its time, in seconds: what it computed since the last restart, as far as is known, and at
  /// least a tenth (kBackstop) of what it waited. Who was stopped for his time has taken his limit.
  double taken() const;
  /// How long to wait at most until the next look.
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
  double computed_ = 0;   ///< In seconds, as far as is known; what its layers did with it.
  double before_ = 0;     ///< The same at the last restart.
  double until_ran_ = 0;  ///< And when it ran last.
  double waited_ = 0;     ///< In seconds, from the last restart to the last look.
  bool is_up_ = false;
  DiskUse files_;  ///< At the last look at them.
};

}  // namespace raycheck::tools
