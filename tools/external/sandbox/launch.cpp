#include "tools/external/sandbox/launch.h"

#include <fcntl.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <spawn.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <thread>

#include "scene/interruption.h"
#include "tools/external/sandbox/descriptor.h"
#include "tools/external/sandbox/process_tree.h"
#include "tools/report/version.h"

namespace raycheck::tools {

namespace fs = std::filesystem;

namespace {

std::atomic<bool> has_large_users = true;

}  // namespace

std::string called(const std::string& limit) {
  return limit.empty() ? "" : fmt::format(" ({})", limit);
}

void use_small_users() { has_large_users = false; }

std::uint64_t next_user() {
  static std::atomic<std::uint64_t> next = 0;
  const auto process = static_cast<std::uint64_t>(getpid());
  const std::uint64_t number = next++;
  if (has_large_users) return std::uint64_t{1} << 30 | process % (1 << 22) << 8 | number % 256;
  constexpr std::uint64_t kFirst = 61184, kCount = 4336;
  return kFirst + (process * 61 + number) % kCount;
}

std::string program_path() { return fmt::format("{}", fmt::join(kProgramFolders, ":")); }

bool is_on_path(const std::string& program) {
  return std::ranges::any_of(kProgramFolders, [&](const char* folder) {
    std::error_code error;
    return fs::is_regular_file(fs::path(folder) / program, error);
  });
}

fs::path helper(const std::string& name) { return readable_copy(program_folder() / name); }

fs::path program_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

fs::path prefix() { return program_folder().parent_path().parent_path(); }

fs::path adapters() {
  const fs::path installed = prefix() / "share" / "raycheck";
  return readable_copy(fs::exists(installed) ? installed
                                             : fs::path(kSourceFolder) / "tools/external/adapters");
}

namespace {

/// Until all layers are in place, this descriptor holds the program's standard error; raycheck-jail
/// leaves it open.
constexpr int kKeptDescriptor = 3;
/// The limit on the time to set up all layers, long enough for a busy machine, and on the error
/// text read from them.
constexpr int kStartSeconds = 60;
constexpr std::size_t kMostSaid = 4096;

/// By default, Java reserves more address space than a process may have.
constexpr const char* kJava =
    "JAVA_TOOL_OPTIONS=-Xmx512m -XX:+UseSerialGC -XX:ReservedCodeCacheSize=64m";

/// From this kernel on, a user's processes are counted separately in each user namespace.
constexpr int kCountsByNamespace[] = {5, 14};

bool counts_by_namespace() {
  utsname system{};
  int major = 0, minor = 0;
  if (uname(&system) != 0 || std::sscanf(system.release, "%d.%d", &major, &minor) != 2)
    return false;
  return std::pair(major, minor) >= std::pair(kCountsByNamespace[0], kCountsByNamespace[1]);
}

/// The number of tasks that this user has now.
std::uint64_t tasks_of_user() {
  std::uint64_t tasks = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
    std::ifstream status(entry.path() / "status");
    uid_t user = 0;
    for (std::string word; status >> word;) {
      if (word == "Uid:") status >> user;
      std::uint64_t threads = 0;
      if (word == "Threads:" && status >> threads && user == getuid()) tasks += threads;
    }
  }
  return tasks;
}

/// The process limit to give to the kernel. The kernel counts all processes of the user: in one
/// namespace if it can; if not, processes of candidates that run in parallel count, too. The user's
/// processes before the first candidate are counted once; otherwise each candidate would raise the
/// limit of the next.
std::uint64_t most_processes(const Confined& confined, std::uint64_t user) {
  const bool counts_its_own = user != 0 || (confined.layers.bubblewrap && counts_by_namespace());
  if (counts_its_own) return confined.limits.processes;
  static const std::uint64_t others = tasks_of_user();
  return others + confined.limits.processes * (1 + std::thread::hardware_concurrency());
}

/// Adds bubblewrap's arguments for the files that the program may read, and for hidden files.
void bind(const Confined& confined, const fs::path& folder, std::uint64_t user,
          std::vector<std::string>& arguments) {
  const auto add = [&](std::initializer_list<std::string> more) {
    arguments.insert(arguments.end(), more);
  };
  std::vector<fs::path> shown = system_paths();
  for (const fs::path& path : shown) add({"--ro-bind-try", path, path});
  // Folders come before their contents. The folder that contains all run folders must not list
  // them, so if it is visible, an empty folder replaces it.
  std::vector<fs::path> readable = confined.readable;
  std::ranges::sort(readable);
  const fs::path of_run = folder.parent_path();
  bool is_emptied = false;
  for (const fs::path& path : readable) {
    add({"--ro-bind", path, path});
    if (!(of_run.string() + "/").starts_with(path.string() + "/")) continue;
    add({"--tmpfs", of_run});
    is_emptied = true;
  }
  // These come later, because they may be copies inside that folder.
  for (const fs::path& path : own_paths()) {
    add({"--ro-bind", path, path});
    shown.push_back(path);
  }
  const std::string jail = helper("raycheck-jail");
  add({"--ro-bind", jail, jail});
  shown.insert(shown.end(), confined.readable.begin(), confined.readable.end());
  for (const fs::path& hidden : hidden_paths()) {
    // The user cannot enter the folder, and neither can bubblewrap, which runs as that user.
    if (user != 0 && !others_may_enter(hidden.parent_path())) continue;
    for (const fs::path& one : shown) {
      std::error_code error;
      const fs::path real = fs::canonical(one, error);
      if (error || !(hidden.string() + "/").starts_with(real.string() + "/")) continue;
      // A link such as /bin becomes a separate folder inside.
      const fs::path path = (one / hidden.lexically_relative(real)).lexically_normal();
      fs::is_directory(hidden) ? add({"--tmpfs", path, "--remount-ro", path})
                               : add({"--ro-bind", "/dev/null", path});
    }
  }
  add({"--bind", folder, folder, "--remount-ro", "/", "--chdir", folder});
  if (is_emptied) add({"--remount-ro", of_run});
}

/// Adds raycheck-jail's arguments for the same files, with Landlock.
void rule(const Confined& confined, const fs::path& folder, std::vector<std::string>& arguments) {
  const auto add = [&](const char* what, const fs::path& path) {
    arguments.push_back(what + path.string());
  };
  for (const fs::path& path : system_paths()) add("reads=", path);
  for (const fs::path& path : own_paths()) add("reads=", path);
  for (const fs::path& path : confined.readable) add("reads=", path);
  for (const fs::path& path : hidden_paths()) add("hidden=", path);
  add("reads=", "/proc");
  for (const char* device : {"null", "zero", "full", "random", "urandom"}) {
    add("writes=", fs::path("/dev") / device);
  }
  add("writes=", folder);
}

std::vector<std::string> jailed(const Confined& confined, const fs::path& folder,
                                std::uint64_t user, const fs::path& group) {
  const std::string jail = helper("raycheck-jail");
  const Limits& limits = confined.limits;
  const Layers& layers = confined.layers;
  std::vector<std::string> arguments = {jail,
                                        fmt::format("cpu={}", limits.cpu_seconds),
                                        fmt::format("memory={}", limits.memory),
                                        fmt::format("file={}", limits.file),
                                        fmt::format("files={}", limits.files),
                                        "supervise=1"};
  const auto add = [&](std::initializer_list<std::string> more) {
    arguments.insert(arguments.end(), more);
  };
  if (!group.empty()) add({"group=" + group.string()});
  if (user != 0) add({fmt::format("user={}", user)});
  if (layers.bubblewrap) {
    // /dev/shm and /tmp get half of its disk limit each.
    const std::string half = std::to_string(std::max<std::uint64_t>(1, limits.disk / 2));
    add({"--", "bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--proc", "/proc",
         "--dev", "/dev", "--remount-ro", "/dev", "--size", half, "--tmpfs", "/dev/shm", "--size",
         half, "--tmpfs", "/tmp"});
    bind(confined, folder, user, arguments);
    add({"--", jail});
  }
  // The limit applies inside bubblewrap's user namespace; outside, the user's other processes would
  // count, too.
  add({fmt::format("processes={}", most_processes(confined, user)),
       fmt::format("error={}", kKeptDescriptor)});
  if (layers.seccomp) add({"seccomp=1"});
  if (layers.seccomp && !layers.bubblewrap && user == 0) add({fmt::format("judge={}", getpid())});
  if (layers.landlock) rule(confined, folder, arguments);
  add({"--"});
  arguments.insert(arguments.end(), confined.arguments.begin(), confined.arguments.end());
  return arguments;
}

/// Waits until all layers are in place. On an error, no process is left.
/// Errors: ProcessFailure with the layers' messages; scene::Interrupted.
void await_start(pid_t pid, int said) try {
  std::string text;
  std::array<char, 4096> buffer{};
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(kStartSeconds);
  for (;;) {
    scene::poll();
    constexpr int kMilliseconds = 100;
    pollfd stream = {said, POLLIN, 0};
    const bool is_in_time = std::chrono::steady_clock::now() < until;
    if (is_in_time && poll(&stream, 1, kMilliseconds) <= 0) continue;
    const ssize_t count = is_in_time ? read(said, buffer.data(), buffer.size()) : 0;
    if (count < 0 && errno == EINTR) continue;
    if (!is_in_time) text += fmt::format("not within {} s", kStartSeconds);
    if (count <= 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    // After the NUL byte the output is that of the confined program.
    if (text.find('\0') != std::string::npos) return;
    if (text.size() > kMostSaid) break;
  }
  end_supervised(pid);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  throw ProcessFailure(FailureKind::kSystem,
                       "could not be started in its sandbox: " + (text.empty() ? "it died" : text));
} catch (const scene::Interrupted&) {
  end_supervised(pid);
  throw;
}

}  // namespace

pid_t launch(const Confined& confined, const fs::path& folder, std::uint64_t user,
             const fs::path& group, const Streams& streams) {
  const std::vector<std::string> arguments = jailed(confined, folder, user, group);
  std::vector<std::string> environment = {"PATH=" + program_path(),
                                          "HOME=" + folder.string(),
                                          "TMPDIR=" + folder.string(),
                                          "LANG=C.UTF-8",
                                          kJava,
                                          "PYTHONPATH=" + adapters().string()};
  Pipe said;  // messages of the layers, until all are in place
  std::vector<char*> argv, envp;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  for (std::string& entry : environment) envp.push_back(entry.data());
  argv.push_back(nullptr);
  envp.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, streams.input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, streams.output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, streams.error, kKeptDescriptor);
  posix_spawn_file_actions_adddup2(&actions, said.write.number(), STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  // The process begins in a new session and process group, so that it cannot join raycheck's, and
  // with default signal handling.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  pid_t pid = -1;
  const int failed = posix_spawn(&pid, argv[0], &actions, &attributes, argv.data(), envp.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    throw ProcessFailure(FailureKind::kSystem, fmt::format("{} cannot be started: {}", arguments[0],
                                                           std::strerror(failed)));
  }
  said.write.close();
  await_start(pid, said.read.number());
  return pid;
}

}  // namespace raycheck::tools
