#ifndef RAYCHECK_TOOLS_EXTERNAL_SANDBOX_WATCH_H_
#define RAYCHECK_TOOLS_EXTERNAL_SANDBOX_WATCH_H_

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

/// Looks now and then at a process and all that it started: what they use together, and how long
/// they have taken. Their time is what passes while they compute or sleep, not while they wait for
/// a processor or a disk that others use.
class Watch {
 public:
  /// `group`: theirs, where they have one, which counts them exactly; else null. `alone`: no other
  /// candidate runs beside it.
  Watch(pid_t root, std::filesystem::path folder, const Limits& limits, const ControlGroup* group,
        bool alone);
  /// Something begins: its time.
  void restart();
  /// Cheap where it is too early for the next look. `doing`: "gave no reply".
  std::optional<Stop> look(const char* doing);
  /// Of its time, in seconds; at most its limit.
  double taken() const;
  /// How long to wait at most until the next look.
  std::chrono::milliseconds until_next() const;

 private:
  using Clock = std::chrono::steady_clock;

  void take_time(double passed, double computed, double others, Waiting waiting);
  std::optional<Stop> excess(const std::vector<ProcessState>& tree);

  pid_t root_;
  std::filesystem::path folder_;
  const Limits& limits_;
  const ControlGroup* group_;
  bool alone_;
  Clock::duration interval_;
  Clock::time_point began_, looked_, next_, next_at_files_;
  double cpu_seconds_ = 0;  ///< At the last look.
  double others_seconds_ = 0;
  double taken_seconds_ = 0;  ///< Of its time.
  DiskUse files_;             ///< At the last look at them.
};

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXTERNAL_SANDBOX_WATCH_H_
