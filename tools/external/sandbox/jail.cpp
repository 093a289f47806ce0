// raycheck-jail LIMIT=VALUE ... -- PROGRAM ARGUMENT ...
//
// Executes PROGRAM in this process, under the given limits:
//   cpu=SECONDS memory=BYTES file=BYTES files=COUNT processes=COUNT   resource limits
//   supervise=1            in a child process; this process ends once all descendants have ended
//   group=PATH             the child starts in this control group; only with supervise
//   user=ID                as this user and group, without other groups; only for root
//   seccomp=1              no sockets, no access to other processes (jail_rules.h)
//   judge=PROCESS          the user has other processes, this one (raycheck) among them: PROGRAM
//                          may not signal or change them
//   reads=PATH writes=PATH hidden=PATH   access to no other files, by Landlock (jail_rules.h); each
//                          may be repeated
//   error=DESCRIPTOR       PROGRAM's standard error; errors of raycheck-jail go to its own, then
//                          a NUL byte once all limits are in place
// Always: no new privileges, no core file, a separate process group, no open descriptors but the
// standard streams and 3, killed when its parent dies. Exits with 125 and a message on failure.

#include <grp.h>
#include <linux/close_range.h>
#include <linux/sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tools/external/sandbox/descriptor.h"
#include "tools/external/sandbox/jail_rules.h"
#include "tools/external/sandbox/process_tree.h"

namespace {

using raycheck::tools::Descriptor;
using raycheck::tools::FileRights;
using raycheck::tools::Reach;

constexpr int kCannot = 125;
/// The first descriptor that is closed.
constexpr unsigned kFirstClosed = 4;

[[noreturn]] void give_up(std::string_view what, const char* why) {
  std::fprintf(stderr, "raycheck-jail: %.*s: %s\n", static_cast<int>(what.size()), what.data(),
               why);
  _exit(kCannot);
}

void require(bool done, std::string_view what) {
  if (!done) give_up(what, std::strerror(errno));
}

void limit(int resource, std::uint64_t value, std::string_view what, std::uint64_t most = 0) {
  const rlimit both = {value, std::max(value, most)};
  require(setrlimit(static_cast<__rlimit_resource>(resource), &both) == 0, what);
}

void become(std::uint64_t user) {
  const auto id = static_cast<uid_t>(user);
  require(setgroups(0, nullptr) == 0 && setgid(id) == 0 && setuid(id) == 0, "user");
}

struct Limits {
  std::uint64_t cpu = 0, memory = 0, file = 0, files = 0, processes = 0, user = 0, supervise = 0,
                seccomp = 0, judge = 0, error = 0;
  FileRights rights;
  std::string group;
};

void read_limit(std::string_view argument, Limits& limits) {
  const std::map<std::string_view, std::uint64_t*> numbers = {
      {"cpu", &limits.cpu},         {"memory", &limits.memory},
      {"file", &limits.file},       {"files", &limits.files},
      {"user", &limits.user},       {"processes", &limits.processes},
      {"seccomp", &limits.seccomp}, {"supervise", &limits.supervise},
      {"judge", &limits.judge},     {"error", &limits.error}};
  const std::map<std::string_view, std::vector<std::filesystem::path>*> paths = {
      {"reads", &limits.rights.reads},
      {"writes", &limits.rights.writes},
      {"hidden", &limits.rights.hidden}};
  const std::size_t equals = std::min(argument.find('='), argument.size() - 1);
  const std::string_view name = argument.substr(0, equals), value = argument.substr(equals + 1);
  if (name == "group") {
    limits.group = value;
  } else if (const auto path = paths.find(name); path != paths.end()) {
    path->second->emplace_back(value);
  } else {
    const auto number = numbers.find(name);
    if (number == numbers.end()) give_up(argument, "unknown limit");
    const auto [end, error] =
        std::from_chars(value.data(), value.data() + value.size(), *number->second);
    if (error != std::errc() || end != value.data() + value.size()) {
      give_up(argument, "not a whole number");
    }
  }
}

void keep(const Limits& limits) {
  bool keeps_signals_in = false;
  if (!limits.rights.empty()) keeps_signals_in = raycheck::tools::keep_to_files(limits.rights);
  if (limits.seccomp == 0) return;
  raycheck::tools::forbid_calls(limits.judge == 0  ? Reach::kOwn
                                : keeps_signals_in ? Reach::kSchedule
                                                   : Reach::kSignal,
                                static_cast<pid_t>(limits.judge));
}

/// Reports that all limits are in place; later output is the program's.
void say_ready(std::uint64_t error) {
  const auto descriptor = static_cast<int>(error);
  require(write(STDERR_FILENO, "", 1) == 1 && dup2(descriptor, STDERR_FILENO) >= 0, "error");
  close(descriptor);
}

/// As in bubblewrap and shells, a signal becomes the exit code 128 + signal.
constexpr int kSignalled = 128;

[[noreturn]] void end_as(int status) {
  _exit(WIFSIGNALED(status) ? kSignalled + WTERMSIG(status) : WEXITSTATUS(status));
}

/// Kills all remaining descendants. If that fails, kills this process, so that raycheck notices it.
void end_all() {
  if (!raycheck::tools::end_children()) kill(getpid(), SIGKILL);
}

/// Waits for the child, then kills its remaining descendants.
[[noreturn]] void wait_for(pid_t child, const sigset_t& awaited) {
  // The streams are closed here, so that they end when the child closes them.
  const int nothing = open("/dev/null", O_RDWR);
  for (int stream = 0; stream < 3; ++stream) dup2(nothing, stream);
  close_range(3, ~0U, 0);
  for (;;) {
    int status = 0;
    for (pid_t ended; (ended = waitpid(-1, &status, WNOHANG)) > 0;) {
      if (ended != child) continue;
      end_all();
      end_as(status);
    }
    if (sigwaitinfo(&awaited, nullptr) == SIGTERM) {
      end_all();
      _exit(kSignalled + SIGTERM);
    }
  }
}

/// Forks into a control group. (Moving a process later would wait for all processors.)
pid_t fork_into(const std::string& group) {
  if (group.empty()) return fork();
  const Descriptor folder(open(group.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.is_open()) return -1;
  clone_args how{};
  how.flags = CLONE_INTO_CGROUP;
  how.exit_signal = SIGCHLD;
  how.cgroup = static_cast<std::uint64_t>(folder.number());
  return static_cast<pid_t>(syscall(SYS_clone3, &how, sizeof how));
}

/// Continues in a child of this process. This process stays as the supervisor: it adopts orphans,
/// kills them when the child ends, and then ends with the child's status. If its own parent dies,
/// it kills all. `group`: the folder of the child's control group; if empty, the child stays in
/// this process's group. On failure returns false, with errno.
bool supervise(const std::string& group) {
  sigset_t awaited, before;
  sigemptyset(&awaited);
  sigaddset(&awaited, SIGTERM);
  sigaddset(&awaited, SIGCHLD);
  if (sigprocmask(SIG_BLOCK, &awaited, &before) != 0) return false;
  if (prctl(PR_SET_CHILD_SUBREAPER, 1) != 0 || prctl(PR_SET_PDEATHSIG, SIGTERM) != 0) return false;
  const pid_t child = fork_into(group);
  if (child < 0) return false;
  if (child > 0) wait_for(child, awaited);
  return sigprocmask(SIG_SETMASK, &before, nullptr) == 0 && prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  Limits limits;
  int k = 1;
  for (; k < argc && std::string_view(argv[k]) != "--"; ++k) read_limit(argv[k], limits);
  if (++k >= argc) give_up("usage", "LIMIT=VALUE ... -- PROGRAM ARGUMENT ...");

  require(prctl(PR_SET_PDEATHSIG, SIGKILL) == 0, "die with the parent");
  if (getpgrp() != getpid()) require(setpgid(0, 0) == 0, "group");
  require(close_range(kFirstClosed, ~0U, CLOSE_RANGE_UNSHARE) == 0, "close");
  // The supervisor must outlive the child to kill all descendants, so it needs a separate process
  // group.
  if (limits.supervise != 0) {
    require(supervise(limits.group), "supervise");
    require(setpgid(0, 0) == 0, "supervise");
  }
  // raycheck ignores this signal, but must report programs that it killed.
  require(std::signal(SIGXFSZ, SIG_DFL) != SIG_ERR, "file");
  limit(RLIMIT_CORE, 0, "core");
  // The hard limit kills it one second later; the SIGXCPU before that shows the reason.
  if (limits.cpu != 0) limit(RLIMIT_CPU, limits.cpu, "cpu", limits.cpu + 1);
  if (limits.memory != 0) limit(RLIMIT_AS, limits.memory, "memory");
  if (limits.file != 0) limit(RLIMIT_FSIZE, limits.file, "file");
  if (limits.files != 0) limit(RLIMIT_NOFILE, limits.files, "files");
  // This comes before the limit on processes, which does not apply to root.
  if (limits.user != 0) become(limits.user);
  if (limits.processes != 0) limit(RLIMIT_NPROC, limits.processes, "processes");
  // Changing the user resets both of these.
  require(prctl(PR_SET_PDEATHSIG, SIGKILL) == 0, "die with the parent");
  require(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "no new privileges");
  try {
    keep(limits);
  } catch (const std::exception& error) {
    give_up("cannot be confined", error.what());
  }
  if (limits.error != 0) say_ready(limits.error);
  execvp(argv[k], argv + k);
  give_up(argv[k], std::strerror(errno));
}
