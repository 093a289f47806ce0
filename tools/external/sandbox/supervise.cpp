#include "tools/external/sandbox/supervise.h"

#include <fcntl.h>
#include <linux/sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>

#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tools {
namespace {

/// As bubblewrap and shells have it.
constexpr int kSignalled = 128;

[[noreturn]] void end_as(int status) {
  _exit(WIFSIGNALED(status) ? kSignalled + WTERMSIG(status) : WEXITSTATUS(status));
}

/// Ends all that is left. Where that cannot be done it is killed itself, so that it shows.
void end_all() {
  if (!end_children()) kill(getpid(), SIGKILL);
}

/// Waits for the child; what it left is killed.
[[noreturn]] void wait_for(pid_t child, const sigset_t& awaited) {
  // The child's end of these is the end of what it says.
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

/// fork() into a control group: to move there later would wait for all processors.
pid_t fork_into(const std::string& group) {
  if (group.empty()) return fork();
  const int folder = open(group.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return -1;
  clone_args how{};
  how.flags = CLONE_INTO_CGROUP;
  how.exit_signal = SIGCHLD;
  how.cgroup = static_cast<std::uint64_t>(folder);
  const auto child = static_cast<pid_t>(syscall(SYS_clone3, &how, sizeof how));
  const int error = errno;
  close(folder);
  errno = error;
  return child;
}

}  // namespace

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

}  // namespace raycheck::tools
