#include "tools/external/sandbox/process_tree.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "tools/external/sandbox/descriptor.h"

namespace raycheck::tools {
namespace {

/// Microseconds between two checks whether processes have ended.
constexpr useconds_t kPauseOfEnding = 500;

/// The contents of a file in /proc by a single read; the files read here are short.
std::string start_of(const std::string& path) {
  std::array<char, 4096> text{};
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  const ssize_t size = read(file.number(), text.data(), text.size());
  return size <= 0 ? "" : std::string(text.data(), static_cast<std::size_t>(size));
}

/// Calls what(number) for each number that names an entry of a folder.
template <class What>
void for_each_number(const std::string& folder, const What& what) {
  const FolderEntries entries(opendir(folder.c_str()), closedir);
  if (!entries) return;
  while (const dirent* const entry = readdir(entries.get())) {
    pid_t number = 0;
    const std::string_view name = entry->d_name;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error == std::errc() && end == name.data() + name.size()) what(number);
  }
}

/// The fields of /proc/PID/stat (proc(5)) from the third on. The name before them may contain any
/// character.
std::vector<std::string> stat_fields(const std::string& line) {
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  return words_of(line.substr(name_end + 1));
}

std::uint64_t number_of(std::string_view text) {
  std::uint64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::optional<ProcessState> state_of(pid_t pid) {
  // Counted from the third field: state, ppid, utime to cstime, num_threads, rss.
  constexpr std::size_t kState = 0, kParent = 1, kProcessorTimes = 11, kThreads = 17, kMemory = 21;
  const std::vector<std::string> fields =
      stat_fields(start_of("/proc/" + std::to_string(pid) + "/stat"));
  if (fields.size() <= kMemory) return {};
  std::uint64_t ticks = 0;
  for (std::size_t k = 0; k < 4; ++k) ticks += number_of(fields[kProcessorTimes + k]);
  ProcessState state;
  state.pid = pid;
  state.parent = static_cast<pid_t>(number_of(fields[kParent]));
  state.cpu_seconds = static_cast<double>(ticks) / static_cast<double>(sysconf(_SC_CLK_TCK));
  state.threads = number_of(fields[kThreads]);
  // A process whose first thread has ended looks dead although other threads run.
  state.is_dead = fields[kState] == "X" || (fields[kState] == "Z" && state.threads <= 1);
  state.memory = number_of(fields[kMemory]) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return state;
}

/// A process's current children, of all its threads: proc_pid_task_tid_children(5).
void add_children(pid_t pid, std::vector<pid_t>& to) {
  const std::string tasks = "/proc/" + std::to_string(pid) + "/task";
  for_each_number(tasks, [&](pid_t task) {
    std::ifstream children(tasks + "/" + std::to_string(task) + "/children");
    for (pid_t child = 0; children >> child;) to.push_back(child);
  });
}

/// Kills the descendants of a process that one walk finds; returns them. Does not read their state,
/// because meanwhile a process could fork and exit, and its child would be missed.
std::vector<pid_t> kill_below(pid_t root) {
  std::vector<pid_t> killed;
  add_children(root, killed);
  for (std::size_t k = 0; k < killed.size(); ++k) {
    // A killed process starts no more processes, so the children found next are all.
    kill(killed[k], SIGKILL);
    add_children(killed[k], killed);
  }
  if (!killed.empty()) return killed;
  // The process has no children, or the kernel does not list them.
  for (const ProcessState& one : process_tree(root)) {
    if (one.pid == root) continue;
    kill(one.pid, SIGKILL);
    killed.push_back(one.pid);
  }
  return killed;
}

/// Whether any thread of the machine waits for a disk.
bool disks_keep_waiting() {
  std::ifstream file("/proc/stat");
  constexpr std::string_view kName = "procs_blocked ";
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(kName)) return number_of(std::string_view(line).substr(kName.size())) > 0;
  }
  return true;
}

}  // namespace

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

std::vector<ProcessState> process_tree(pid_t root, double* computed) {
  std::vector<ProcessState> all, tree;
  for_each_number("/proc", [&](pid_t pid) {
    if (const auto state = state_of(pid)) (pid == root ? tree : all).push_back(*state);
  });
  // Generation by generation.
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const pid_t parent = tree[k].pid;
    const auto rest = std::stable_partition(
        all.begin(), all.end(), [&](const ProcessState& one) { return one.parent != parent; });
    tree.insert(tree.end(), rest, all.end());
    all.erase(rest, all.end());
  }
  if (computed != nullptr) {
    *computed = 0;
    for (const ProcessState& one : tree) *computed += one.cpu_seconds;
  }
  std::erase_if(tree, [](const ProcessState& one) { return one.is_dead; });
  return tree;
}

bool want_to_run(const std::vector<ProcessState>& processes) {
  bool runs = false, sleeps = false;
  for (const ProcessState& process : processes) {
    const std::string tasks = "/proc/" + std::to_string(process.pid) + "/task";
    for_each_number(tasks, [&](pid_t task) {
      const std::vector<std::string> fields =
          stat_fields(start_of(tasks + "/" + std::to_string(task) + "/stat"));
      runs = runs || (!fields.empty() && fields[0] == "R");
      sleeps = sleeps || (!fields.empty() && fields[0] == "D");
    });
  }
  // State D is also that of a parent whose child from vfork() has not called exec() yet.
  return runs || (sleeps && disks_keep_waiting());
}

MemoryUse memory_together(const std::vector<ProcessState>& processes) {
  MemoryUse use;
  for (const ProcessState& process : processes) {
    const std::string text = start_of("/proc/" + std::to_string(process.pid) + "/smaps_rollup");
    const auto bytes_of = [&](std::string_view name) -> std::optional<std::uint64_t> {
      const std::size_t at = text.find(name);
      if (at == std::string::npos) return {};
      const std::size_t digit = text.find_first_of("0123456789", at);
      return number_of(std::string_view(text).substr(std::min(digit, text.size()))) << 10;
    };
    const std::uint64_t all = bytes_of("\nPss:").value_or(process.memory);
    const std::uint64_t shared = std::min(bytes_of("\nPss_Shmem:").value_or(0), all);
    use.own += all - shared;
    use.shared += shared;
  }
  return use;
}

bool end_children() {
  const auto deadline = std::chrono::steady_clock::now() + kMostEnding;
  for (std::vector<pid_t> before; std::chrono::steady_clock::now() < deadline;) {
    std::vector<pid_t> killed = kill_below(getpid());
    pid_t ended = 0;
    do {
      ended = waitpid(-1, nullptr, WNOHANG);
    } while (ended > 0);
    if (ended < 0 && errno == ECHILD) return true;
    // If there are new processes, which may start others, there is no pause.
    if (killed == before) usleep(kPauseOfEnding);
    before = std::move(killed);
  }
  return false;
}

bool end_supervised(pid_t supervisor) {
  // The descendants are killed first, so that the supervisor need not compete with them.
  kill_below(supervisor);
  kill(supervisor, SIGTERM);
  const auto deadline = std::chrono::steady_clock::now() + 2 * kMostEnding;
  int status = 0;
  for (;;) {
    // Another process may have stopped the supervisor by a signal.
    kill(supervisor, SIGCONT);
    const pid_t ended = waitpid(supervisor, &status, WNOHANG);
    if (ended == supervisor) return !WIFSIGNALED(status);
    if (ended < 0 && errno != EINTR) return true;
    if (std::chrono::steady_clock::now() >= deadline) break;
    usleep(kPauseOfEnding);
  }
  kill_below(supervisor);
  kill(supervisor, SIGKILL);
  while (waitpid(supervisor, nullptr, 0) < 0 && errno == EINTR) {
  }
  return false;
}

}  // namespace raycheck::tools
