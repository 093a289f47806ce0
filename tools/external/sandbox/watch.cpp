#include "tools/external/sandbox/watch.h"

#include <fmt/core.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "tools/external/sandbox/control_group.h"
#include "tools/external/sandbox/nameless_files.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using std::chrono::duration;
using std::chrono::duration_cast;
using std::chrono::milliseconds;

constexpr milliseconds kInterval{100}, kLeastInterval{5};
/// Looks in the time that a limit gives.
constexpr double kLooks = 10;
/// A look takes at most this part of the time, but never waits for longer than that.
constexpr int kShare = 10;
constexpr std::chrono::steady_clock::duration kMostInterval = std::chrono::seconds(1);
/// What waits for others is stopped nevertheless after so many times its time, and so many seconds.
constexpr double kMostWaiting = 10, kLeastWaiting = 120;
/// Processes that keep it, and are not its own: bubblewrap's and raycheck-jail.
constexpr std::uint64_t kOfLayers = 4;
/// Of a span, what has computed nearly all of it has not waited.
constexpr double kNearlyAll = 0.9;

std::uint64_t available_memory() {
  std::ifstream file("/proc/meminfo");
  std::string name;
  std::uint64_t kib = 0;
  for (std::string unit; file >> name >> kib; std::getline(file, unit)) {
    if (name == "MemAvailable:") return kib << 10;
  }
  return ~std::uint64_t{0};
}

}  // namespace

std::string lack_of_room(const fs::path& folder) {
  struct statvfs disk {};
  if (statvfs(folder.c_str(), &disk) == 0 &&
      std::uint64_t{disk.f_bavail} * disk.f_frsize < kDiskReserve) {
    return fmt::format("the machine has less than {} MiB of disk left", kDiskReserve >> 20);
  }
  if (available_memory() < kMemoryReserve) {
    return fmt::format("the machine has less than {} MiB of memory left", kMemoryReserve >> 20);
  }
  return "";
}

std::string memory_words(const Limits& limits) {
  return fmt::format("was stopped: it uses more than {} MiB of memory{}", limits.memory >> 20,
                     called(limits.names.memory));
}

Watch::Watch(pid_t root, fs::path folder, const Limits& limits, const ControlGroup* group,
             bool alone)
    : root_(root), folder_(std::move(folder)), limits_(limits), group_(group), alone_(alone) {
  const auto part = duration_cast<milliseconds>(duration<double>(limits.seconds / kLooks));
  interval_ = std::clamp(part, kLeastInterval, kInterval);
  restart();
}

void Watch::restart() {
  taken_seconds_ = 0;
  began_ = looked_ = Clock::now();
  next_ = looked_ + interval_;
}

double Watch::taken() const {
  const double since = duration<double>(Clock::now() - looked_).count();
  return std::min(taken_seconds_ + since, limits_.seconds);
}

milliseconds Watch::until_next() const {
  return std::max(duration_cast<milliseconds>(next_ - Clock::now()) + milliseconds(1),
                  milliseconds(1));
}

/// Nobody waits longer for a processor than others compute. That is asked of who is alone: what
/// many short processes of a neighbour compute the system does not tell.
void Watch::take_time(double passed, double computed, double others, Waiting waiting) {
  double waited = waiting == Waiting::kForNothing ? 0 : std::clamp(passed - computed, 0.0, passed);
  if (alone_ && group_ == nullptr && waiting == Waiting::kForAProcessor) {
    waited = std::min(waited, others);
  }
  taken_seconds_ += passed - waited;
}

/// Of the hand-in's own limits. Many files take long to look at, and are looked at more rarely:
/// nothing else waits for them.
std::optional<Stop> Watch::excess(const std::vector<ProcessState>& tree) {
  std::uint64_t threads = 0;
  for (const ProcessState& one : tree) threads += one.threads;
  if (threads > limits_.processes + kOfLayers) {
    return Stop{FailureKind::kEnded,
                fmt::format("was stopped: it has more than {} processes and threads{}",
                            limits_.processes, called(limits_.names.processes))};
  }
  const NamelessFiles nameless = nameless_files(tree);
  std::uint64_t memory = nameless.in_memory;
  for (const ProcessState& one : tree) memory += one.memory;
  if (memory > limits_.memory) {
    // What is mapped of shared memory was counted with each process.
    const MemoryUse use = memory_together(tree);
    memory = use.own + std::max(use.shared, nameless.in_memory);
  }
  if (memory > limits_.memory || (group_ != nullptr && group_->has_met_memory_limit())) {
    return Stop{FailureKind::kEnded, memory_words(limits_)};
  }
  if (const auto begin = Clock::now(); begin >= next_at_files_) {
    files_ = disk_use(folder_);
    const auto end = Clock::now();
    next_at_files_ = end + std::min((end - begin) * kShare, kMostInterval);
  }
  if (files_.bytes + nameless.on_disk > limits_.disk) {
    return Stop{FailureKind::kEnded, fmt::format("was stopped: its files take more than {} MiB{}",
                                                 limits_.disk >> 20, called(limits_.names.disk))};
  }
  if (files_.is_too_deep) {
    return Stop{FailureKind::kEnded, "was stopped: it nests folders too deep"};
  }
  if (files_.is_closed) {
    return Stop{FailureKind::kEnded,
                "was stopped: it closes a folder, so that none can look into it"};
  }
  if (files_.are_too_many) {
    return Stop{FailureKind::kEnded,
                fmt::format("was stopped: it has more than {} files", kMostFiles)};
  }
  return {};
}

std::optional<Stop> Watch::look(const char* doing) {
  const auto now = Clock::now();
  if (now < next_) return {};
  double others = 0;
  const std::vector<ProcessState> tree = process_tree(root_, &others);
  double computed = 0;
  for (const ProcessState& one : tree) computed += one.cpu_seconds;
  if (group_ != nullptr) computed = group_->cpu_seconds();
  computed = std::max(computed - std::exchange(cpu_seconds_, computed), 0.0);
  const double passed = duration<double>(now - std::exchange(looked_, now)).count();
  others = std::max(others - std::exchange(others_seconds_, others), 0.0);
  take_time(passed, computed, others,
            computed < kNearlyAll * passed ? waiting_of(tree) : Waiting::kForNothing);
  if (taken_seconds_ >= limits_.seconds) {
    return Stop{FailureKind::kTimeUp, fmt::format("{} within {} s{}", doing, limits_.seconds,
                                                  called(limits_.names.seconds))};
  }
  const double most = std::max(kMostWaiting * limits_.seconds, kLeastWaiting);
  if (duration<double>(now - began_).count() >= most) {
    return Stop{FailureKind::kSystem,
                fmt::format("{} within {} s of which it computed {:.1f}: others use the machine",
                            doing, most, taken_seconds_)};
  }
  if (auto stop = excess(tree)) return stop;
  if (const std::string lack = lack_of_room(folder_); !lack.empty()) {
    return Stop{FailureKind::kSystem, "was stopped: " + lack};
  }
  const auto end = Clock::now();
  next_ = end + std::clamp((end - now) * kShare, interval_, kMostInterval);
  return {};
}

}  // namespace raycheck::tools
