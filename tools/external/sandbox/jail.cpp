// raycheck-jail LIMIT=VALUE ... -- PROGRAM ARGUMENT ...
//
// Becomes PROGRAM, which then may not do what the limits forbid:
//   cpu=SECONDS memory=BYTES file=BYTES files=COUNT processes=COUNT   its resources
//   user=ID                           as that user and group, and no other group; only for root
//   seccomp=1                         without sockets, without looking into other processes
// Always: no more privileges than it has, no core file, a group of its own, nothing open but the
// standard streams, killed when its parent dies. Exits with 125, after a line about it, when it
// cannot.

#include <grp.h>
#include <linux/close_range.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace {

constexpr int kCannot = 125;

[[noreturn]] void give_up(std::string_view what, const char* why) {
  std::fprintf(stderr, "raycheck-jail: %.*s: %s\n", static_cast<int>(what.size()), what.data(),
               why);
  _exit(kCannot);
}

void require(bool done, std::string_view what) {
  if (!done) give_up(what, std::strerror(errno));
}

void limit(int resource, std::uint64_t value, std::string_view what) {
  const rlimit both = {value, value};
  require(setrlimit(static_cast<__rlimit_resource>(resource), &both) == 0, what);
}

void become(std::uint64_t user) {
  const auto id = static_cast<uid_t>(user);
  require(setgroups(0, nullptr) == 0 && setgid(id) == 0 && setuid(id) == 0, "user");
}

void forbid_calls() {
  constexpr const char* kForbidden[] = {"socket",
                                        "connect",
                                        "bind",
                                        "listen",
                                        "accept",
                                        "accept4",
                                        "ptrace",
                                        "process_vm_readv",
                                        "process_vm_writev",
                                        "process_madvise",
                                        "pidfd_getfd",
                                        "kcmp",
                                        "perf_event_open",
                                        "bpf",
                                        "userfaultfd",
                                        "io_uring_setup",
                                        "keyctl",
                                        "add_key",
                                        "request_key",
                                        "mount",
                                        "umount2",
                                        "pivot_root",
                                        "move_mount",
                                        "open_tree",
                                        "fsopen",
                                        "setns",
                                        "unshare",
                                        "open_by_handle_at",
                                        "name_to_handle_at",
                                        "kexec_load",
                                        "init_module",
                                        "finit_module",
                                        "delete_module",
                                        "quotactl",
                                        "swapon",
                                        "swapoff",
                                        "reboot"};
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
  require(filter != nullptr, "seccomp");
  for (const char* name : kForbidden) {
    const int call = seccomp_syscall_resolve_name(name);
    if (call == __NR_SCMP_ERROR) continue;  // not one of this machine's
    require(seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 0) == 0, name);
  }
  // Java's files need a pair of streams, which lead nowhere else; datagrams can be addressed.
  const scmp_arg_cmp is_no_stream = {1, SCMP_CMP_NE, SOCK_STREAM, 0};
  require(seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(socketpair), 1,
                                 &is_no_stream) == 0,
          "socketpair");
  require(seccomp_load(filter) == 0, "seccomp");
  seccomp_release(filter);
}

struct Limits {
  std::uint64_t cpu = 0, memory = 0, file = 0, files = 0, processes = 0, user = 0, seccomp = 0;
};

void read_limit(std::string_view argument, Limits& limits) {
  const std::size_t equals = argument.find('=');
  const std::string_view name = argument.substr(0, equals);
  std::uint64_t* value = name == "cpu"         ? &limits.cpu
                         : name == "memory"    ? &limits.memory
                         : name == "file"      ? &limits.file
                         : name == "files"     ? &limits.files
                         : name == "processes" ? &limits.processes
                         : name == "user"      ? &limits.user
                         : name == "seccomp"   ? &limits.seccomp
                                               : nullptr;
  if (value == nullptr || equals == std::string_view::npos) give_up(argument, "no such limit");
  const char* const end = argument.data() + argument.size();
  const auto [at, error] = std::from_chars(argument.data() + equals + 1, end, *value);
  if (error != std::errc() || at != end) give_up(argument, "not a whole number");
}

}  // namespace

int main(int argc, char** argv) {
  Limits limits;
  int k = 1;
  for (; k < argc && std::string_view(argv[k]) != "--"; ++k) read_limit(argv[k], limits);
  if (++k >= argc) give_up("usage", "LIMIT=VALUE ... -- PROGRAM ARGUMENT ...");

  require(prctl(PR_SET_PDEATHSIG, SIGKILL) == 0, "die with the parent");
  if (getpgrp() != getpid()) require(setpgid(0, 0) == 0, "group");
  require(close_range(3, ~0U, CLOSE_RANGE_UNSHARE) == 0, "close");
  limit(RLIMIT_CORE, 0, "core");
  if (limits.cpu != 0) limit(RLIMIT_CPU, limits.cpu, "cpu");
  if (limits.memory != 0) limit(RLIMIT_AS, limits.memory, "memory");
  if (limits.file != 0) limit(RLIMIT_FSIZE, limits.file, "file");
  if (limits.files != 0) limit(RLIMIT_NOFILE, limits.files, "files");
  // Before the limit on processes, which does not bind root.
  if (limits.user != 0) become(limits.user);
  if (limits.processes != 0) limit(RLIMIT_NPROC, limits.processes, "processes");
  // Both are lost with another user.
  require(prctl(PR_SET_PDEATHSIG, SIGKILL) == 0, "die with the parent");
  require(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "no new privileges");
  if (limits.seccomp != 0) forbid_calls();
  execvp(argv[k], argv + k);
  give_up(argv[k], std::strerror(errno));
}
