#include "tools/external/sandbox/control_group.h"

#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kGroupPrefix = "raycheck-", kLeafPrefix = "judge-";
/// bubblewrap adds two processes: one waits outside, one inside adopts orphans.
constexpr std::uint64_t kOfBubblewrap = 2;
/// The number of checks whether all processes of a group have died, and the microseconds between
/// two.
constexpr int kMostLooks = 10000;
constexpr useconds_t kLookPause = 500;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool has_word(const std::string& text, const std::string& word) {
  const std::vector<std::string> words = words_of(text);
  return std::ranges::find(words, word) != words.end();
}

/// The number after a name; 0 if the name is missing.
std::uint64_t value_of(const std::string& text, const std::string& name) {
  const std::vector<std::string> words = words_of(text);
  const auto at = std::ranges::find(words, name);
  std::uint64_t value = 0;
  if (at != words.end() && at + 1 != words.end()) {
    std::from_chars((at + 1)->data(), (at + 1)->data() + (at + 1)->size(), value);
  }
  return value;
}

/// Writes a value with a single write(), as the kernel requires.
void write_value(const fs::path& path, const std::string& value) {
  const Descriptor file(open(path.c_str(), O_WRONLY | O_CLOEXEC));
  // Error messages must not contain names of groups, which differ from run to run.
  if (!file.is_open() || write(file.number(), value.data(), value.size()) < 0) {
    throw std::system_error(errno, std::generic_category(), path.filename());
  }
}

bool try_value(const fs::path& path, const std::string& value) {
  try {
    write_value(path, value);
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

fs::path new_group(const fs::path& path) {
  constexpr mode_t kMode = 0755;
  if (mkdir(path.c_str(), kMode) != 0) {
    throw std::system_error(errno, std::generic_category(), path.parent_path());
  }
  return path;
}

/// Decodes the \040 and similar escapes of /proc/self/mountinfo.
std::string unescaped(const std::string& text) {
  constexpr std::size_t kDigits = 3;
  std::string result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    unsigned char byte = 0;
    const char* const begin = text.data() + k + 1;
    const char* const end = begin + std::min(kDigits, text.size() - k - 1);
    const bool is_escape = text[k] == '\\' && end == begin + kDigits &&
                           std::from_chars(begin, end, byte, 8).ptr == end;
    result += is_escape ? static_cast<char>(byte) : text[k];
    if (is_escape) k += kDigits;
  }
  return result;
}

/// Opens and locks a group's folder. The lock lasts until its owner ends, in whatever way.
Descriptor held_folder(const fs::path& group, int how) {
  Descriptor folder(open(group.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (flock(folder.number(), how | LOCK_NB) != 0) folder.close();
  return folder;
}

/// Removes groups of dead runs: no process has their id and their folder is not locked (ids differ
/// between namespaces). A group with this process's id is left from an earlier process. Groups that
/// still have processes stay.
void remove_dead_groups(const fs::path& own) {
  std::error_code error;
  for (fs::directory_iterator at(own, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename();
    std::string_view rest = name;
    if (!rest.starts_with(kGroupPrefix)) continue;
    rest.remove_prefix(kGroupPrefix.size());
    if (rest.starts_with(kLeafPrefix)) rest.remove_prefix(kLeafPrefix.size());
    pid_t pid = 0;
    std::from_chars(rest.data(), rest.data() + rest.size(), pid);
    if (pid <= 0) continue;
    if (pid != getpid() && (::kill(pid, 0) == 0 || errno != ESRCH)) continue;
    const Descriptor folder = held_folder(at->path(), LOCK_EX);
    if (folder.is_open()) rmdir(at->path().c_str());
  }
}

/// The control groups of this run.
class RunGroups {
 public:
  RunGroups()
      : own_(own_control_group(text_of("/proc/self/mountinfo"), text_of("/proc/self/cgroup"))) {
    remove_dead_groups(own_);
    // Only the root group has no type; only it may contain processes and have subgroups with
    // controllers.
    if (fs::exists(own_ / "cgroup.type")) move_to_leaf();
    const std::string offered = text_of(own_ / "cgroup.controllers");
    for (const char* name : {"memory", "pids", "cpu"}) {
      const bool is_new = has_word(offered, name) && !has_word(controllers(), name);
      if (is_new && try_value(own_ / kControllers, std::string("+") + name)) {
        enabled_.emplace_back(name);
      }
    }
  }
  ~RunGroups() {
    // In the root group, other runs may use the controllers that this run enabled.
    if (leaf_.empty()) return;
    for (const std::string& name : enabled_) try_value(own_ / kControllers, "-" + name);
    try_value(own_ / kProcesses, "0");
    rmdir(leaf_.c_str());
  }
  RunGroups(const RunGroups&) = delete;
  RunGroups& operator=(const RunGroups&) = delete;

  const fs::path& own() const { return own_; }
  GroupLimits limits() const {
    return {has_word(controllers(), "memory"), has_word(controllers(), "pids")};
  }

 private:
  static constexpr const char* kControllers = "cgroup.subtree_control";
  static constexpr const char* kProcesses = "cgroup.procs";

  std::string controllers() const { return text_of(own_ / kControllers); }

  /// Moves raycheck to a subgroup, because a group whose subgroups have controllers may not contain
  /// processes.
  void move_to_leaf() {
    for (const std::string& one : words_of(text_of(own_ / kProcesses))) {
      if (one == std::to_string(getpid())) continue;
      throw std::runtime_error(
          fmt::format("{} holds other processes besides raycheck", own_.string()));
    }
    const fs::path leaf =
        new_group(own_ / fmt::format("{}{}{}", kGroupPrefix, kLeafPrefix, getpid()));
    try {
      write_value(leaf / kProcesses, "0");
    } catch (const std::system_error& error) {
      rmdir(leaf.c_str());
      throw std::system_error(error.code(), own_);
    }
    leaf_ = leaf;
  }

  fs::path own_, leaf_;
  std::vector<std::string> enabled_;
};

std::optional<RunGroups>& run_groups() {
  static std::optional<RunGroups> groups;
  return groups;
}

}  // namespace

fs::path own_control_group(const std::string& mountinfo, const std::string& cgroup) {
  constexpr std::string_view kOwn = "0::";
  std::string own;
  std::istringstream groups(cgroup);
  for (std::string line; std::getline(groups, line);) {
    if (line.starts_with(kOwn)) own = line.substr(kOwn.size());
  }
  bool is_mounted = false;
  std::istringstream mounts(mountinfo);
  for (std::string line; std::getline(mounts, line);) {
    if (line.find(" - cgroup2 ") == std::string::npos) continue;
    is_mounted = true;
    // Fields: id, parent, device, mounted folder, mount point.
    constexpr std::size_t kRoot = 3, kPoint = 4;
    const std::vector<std::string> fields = words_of(line);
    const std::string root = unescaped(fields.at(kRoot));
    const std::string below = root == "/" ? root : root + "/";
    if (own.starts_with("/..") || !(own + "/").starts_with(below)) continue;
    const std::string rest = own.substr(std::min(below.size(), own.size()));
    const fs::path point = unescaped(fields.at(kPoint));
    return rest.empty() ? point : point / rest;
  }
  throw std::runtime_error(
      is_mounted && !own.empty()
          ? fmt::format("raycheck's own control group, {}, is not mounted", own)
          : "this machine has no control groups of version 2");
}

bool has_met_memory_limit(const std::string& events) {
  // "oom_kill" counts all kills; "oom" is counted only in the group whose limit was met.
  return value_of(events, "oom") > 0 && value_of(events, "oom_kill") > 0;
}

GroupLimits begin_control_groups() { return run_groups().emplace().limits(); }

void end_control_groups() { run_groups().reset(); }

ControlGroup::ControlGroup(const Layers& layers, const Limits& limits) {
  static std::atomic<std::uint64_t> number = 0;
  path_ = new_group(run_groups().value().own() /
                    fmt::format("{}{}-{}", kGroupPrefix, getpid(), number++));
  folder_ = held_folder(path_, LOCK_SH);
  try {
    if (layers.group_memory) {
      write_value(path_ / "memory.max", std::to_string(limits.memory));
      write_value(path_ / "memory.oom.group", "1");
      const fs::path swap = path_ / "memory.swap.max";
      if (fs::exists(swap)) write_value(swap, "0");
    }
    if (layers.group_processes) {
      const std::uint64_t more = layers.bubblewrap ? kOfBubblewrap : 0;
      write_value(path_ / "pids.max", std::to_string(limits.processes + more));
    }
  } catch (const std::exception&) {
    rmdir(path_.c_str());
    throw;
  }
}

ControlGroup::~ControlGroup() {
  kill();
  for (int k = 0; k < kMostLooks && rmdir(path_.c_str()) != 0 && errno == EBUSY; ++k) {
    usleep(kLookPause);
  }
}

double ControlGroup::cpu_seconds() const {
  constexpr double kMicro = 1e-6;
  return kMicro * static_cast<double>(value_of(text_of(path_ / "cpu.stat"), "usage_usec"));
}

bool ControlGroup::has_met_memory_limit() const {
  return tools::has_met_memory_limit(text_of(path_ / "memory.events"));
}

bool ControlGroup::kill() const { return try_value(path_ / "cgroup.kill", "1"); }

}  // namespace raycheck::tools
