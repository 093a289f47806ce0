#include "tools/external/sandbox/watch.h"

#include <fmt/core.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "tools/external/sandbox/control_group.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using std::chrono::duration;
using std::chrono::duration_cast;
using std::chrono::milliseconds;

constexpr milliseconds kInterval{100}, kLeastInterval{5};
/// The number of checks within a time limit.
constexpr double kLooks = 10;
/// Checks of files take at most 1/kShare of the time, but at most kMostInterval passes between two.
constexpr int kShare = 10;
constexpr std::chrono::steady_clock::duration kMostInterval = std::chrono::seconds(1);
/// The number of processes that the isolation adds: bubblewrap's and raycheck-jail.
constexpr std::uint64_t kOfLayers = 4;
/// A program that uses less CPU time than this share of a period counts as idle.
constexpr double kNextToNothing = 0.01;

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
             bool has_neighbours)
    : root_(root),
      folder_(std::move(folder)),
      limits_(limits),
      group_(group),
      has_neighbours_(has_neighbours) {
  const auto part = duration_cast<milliseconds>(duration<double>(limits.seconds / kLooks));
  interval_ = std::clamp(part, kLeastInterval, kInterval);
  next_ = Clock::now();
  restart();
}

/// Updates the CPU time; returns the processes. In a single check a process may be counted twice
/// (alive and reaped) or not at all.
std::vector<ProcessState> Watch::count() {
  double computed = 0;
  std::vector<ProcessState> tree = process_tree(root_, &computed);
  computed_ = std::max(computed_, group_ != nullptr ? group_->cpu_seconds() : computed);
  return tree;
}

void Watch::restart() {
  const auto now = Clock::now();
  if (now >= next_) {
    count();
    next_ = now + interval_;
  }
  before_ = until_ran_ = computed_;
  waited_ = slept_ = 0;
  looked_ = ran_ = now;
  is_up_ = false;
}

void Watch::end(double cpu_seconds) {
  computed_ = std::max(computed_, group_ != nullptr ? group_->cpu_seconds() : cpu_seconds);
}

double Watch::taken() const {
  if (is_up_) return limits_.seconds;
  return std::min(std::max(computed_ - before_, waited() / kBackstop), limits_.seconds);
}

double Watch::waited() const { return waited_ + duration<double>(Clock::now() - looked_).count(); }

double Watch::limits_waited() const {
  return std::max(1.0, slept_ / std::max(limits_.seconds, kLeastBackstop));
}

milliseconds Watch::until_next() const {
  return std::max(duration_cast<milliseconds>(next_ - Clock::now()) + milliseconds(1),
                  milliseconds(1));
}

std::optional<Stop> Watch::excess(const std::vector<ProcessState>& tree) {
  const auto stopped = [](const std::string& words) {
    return Stop{FailureKind::kEnded, "was stopped: " + words};
  };
  std::uint64_t threads = 0, memory = 0;
  for (const ProcessState& one : tree) {
    threads += one.threads;
    memory += one.memory;
  }
  if (threads > limits_.processes + kOfLayers) {
    return stopped(fmt::format("it has more than {} processes and threads{}", limits_.processes,
                               called(limits_.names.processes)));
  }
  const NamelessFiles nameless = nameless_files(tree);
  if (memory + nameless.in_memory > limits_.memory) {
    // Shared memory was counted in each process.
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
    return stopped(fmt::format("its files take more than {} MiB{}", limits_.disk >> 20,
                               called(limits_.names.disk)));
  }
  if (files_.is_too_deep) return stopped("its folders are nested too deep");
  if (files_.is_closed) return stopped("it made a folder unreadable");
  if (files_.are_too_many) return stopped(fmt::format("it has more than {} files", kMostFiles));
  return {};
}

std::optional<Stop> Watch::time_up(const char* doing, const std::vector<ProcessState>& tree) {
  const double limit = limits_.seconds;
  const std::string name = called(limits_.names.seconds);
  if (computed_ - before_ >= limit) {
    return Stop{FailureKind::kTimeUp,
                fmt::format("{} within {} s of CPU time{}", doing, limit, name)};
  }
  const auto now = Clock::now();
  const FailureKind kind = has_neighbours_ ? FailureKind::kSystem : FailureKind::kTimeUp;
  const double idle = std::max(limit, kLeastBackstop);
  const bool wants_to_run = want_to_run(tree);
  if (computed_ - until_ran_ >= kNextToNothing * idle || wants_to_run) {
    ran_ = now;
    until_ran_ = computed_;
  }
  const double since = duration<double>(now - looked_).count();
  waited_ += wants_to_run ? since / kBackstop : since;
  slept_ += wants_to_run ? 0 : since;
  looked_ = now;
  if (duration<double>(now - ran_).count() >= idle) {
    return Stop{kind, fmt::format("{}, and used almost no CPU time for {} s{}", doing, idle, name)};
  }
  const double most = std::max(kBackstop * limit, kLeastBackstop);
  if (waited_ >= most) {
    return Stop{
        kind, fmt::format("{} within {} s of waiting, and used less than {} s of CPU time{}", doing,
                          most, limit, name)};
  }
  return {};
}

std::optional<Stop> Watch::look(const char* doing) {
  const auto now = Clock::now();
  if (now < next_) return {};
  const std::vector<ProcessState> tree = count();
  if (auto stop = time_up(doing, tree)) {
    is_up_ = true;
    return stop;
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
