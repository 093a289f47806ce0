#include "tools/external/sandbox/jail_rules.h"

#include <linux/falloc.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <system_error>

#include "tools/external/sandbox/descriptor.h"

namespace raycheck::tools {

namespace {

constexpr std::array kForbidden = {
    "socket", "connect", "bind", "listen", "accept", "accept4",
    // Access to other processes.
    "ptrace", "process_vm_readv", "process_vm_writev", "process_madvise", "process_mrelease",
    "pidfd_getfd", "kcmp", "perf_event_open", "bpf", "userfaultfd", "io_uring_setup",
    // Objects that outlive the process.
    "keyctl", "add_key", "request_key", "shmget", "shmat", "shmctl", "msgget", "msgsnd", "msgrcv",
    "msgctl", "semget", "semop", "semtimedop", "semctl", "mq_open", "mq_unlink",
    // Other file systems and namespaces.
    "mount", "umount2", "pivot_root", "chroot", "move_mount", "open_tree", "fsopen",
    "mount_setattr", "setns", "unshare", "open_by_handle_at", "name_to_handle_at", "kexec_load",
    "kexec_file_load", "init_module", "finit_module", "delete_module", "quotactl", "swapon",
    "swapoff", "reboot"};

/// Flags of clone() for a new namespace, in which the process would be root.
constexpr std::initializer_list<std::uint64_t> kNamespaces = {
    CLONE_NEWUSER, CLONE_NEWNS,  CLONE_NEWPID,   CLONE_NEWNET,
    CLONE_NEWIPC,  CLONE_NEWUTS, CLONE_NEWCGROUP};

/// Arguments of fcntl() and ioctl() that send signals from a stream to any process, or put input
/// into a terminal. The headers define the first two only with other feature macros.
constexpr std::uint64_t kSetSignal = 10, kSetOwnerOfKind = 15, kSetOwnerOfStream = 0x8901,
                        kSetGroupOfSocket = 0x8902;

/// Arguments of ioctl(), older forms of fallocate(), which reserve disk space beyond a file's
/// limit. Only headers for XFS programs define them.
struct Room {
  std::array<char, 48> bytes;
};
constexpr std::array<std::uint64_t, 3> kReserve = {_IOW('X', 40, Room), _IOW('X', 42, Room),
                                                   _IOW('X', 57, Room)};

/// Calls whose first argument is a process; 0 is the caller itself.
constexpr std::array kOfAProcess = {"prlimit64",      "sched_setaffinity", "sched_setscheduler",
                                    "sched_setparam", "sched_setattr",     "migrate_pages",
                                    "move_pages"};
/// Calls whose second argument is an id, and whose first is its kind; `user` is the kind for users.
struct OfAKind {
  const char* name;
  std::uint64_t user;
};
constexpr std::array kOfAKind = {OfAKind{"setpriority", PRIO_USER}, OfAKind{"ioprio_set", 3}};

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ALLOW)) {
    if (context_ == nullptr) fail(ENOMEM, "filter");
  }
  ~Filter() { seccomp_release(context_); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  /// Forbids a call if all conditions hold; if there are none, always. Skips calls that this
  /// architecture lacks.
  void forbid(const char* name, std::initializer_list<scmp_arg_cmp> where = {},
              int answer = EPERM) const {
    const int call = seccomp_syscall_resolve_name(name);
    if (call == __NR_SCMP_ERROR) return;
    const int failed =
        seccomp_rule_add_array(context_, SCMP_ACT_ERRNO(static_cast<std::uint32_t>(answer)), call,
                               static_cast<unsigned>(where.size()), where.begin());
    if (failed != 0) fail(-failed, name);
  }
  void load() const {
    const int failed = seccomp_load(context_);
    if (failed != 0) fail(-failed, "load");
  }

  [[noreturn]] static void fail(int error, const std::string& what) {
    throw std::system_error(error, std::generic_category(), "seccomp: " + what);
  }

 private:
  scmp_filter_ctx context_;
};

/// For a 32-bit argument, the kernel uses only the lower half of the register.
constexpr std::uint64_t kLowerHalf = 0xffffffff;

scmp_arg_cmp is(unsigned argument, std::uint64_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, kLowerHalf, value};
}
scmp_arg_cmp is_not(unsigned argument, std::uint64_t value) {
  return {argument, SCMP_CMP_NE, value, 0};
}

/// Allows kill() and rt_sigqueueinfo() only to the process itself and its group. This is a separate
/// filter, because libseccomp compares an argument only once per rule.
void keep_signals_in() {
  const auto own = static_cast<std::uint32_t>(getpid());
  constexpr std::uint32_t kTarget = offsetof(seccomp_data, args);  // its lower half
  std::array program = {sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_kill, 2, 0),
                        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_rt_sigqueueinfo, 1, 0),
                        sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
                        sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kTarget),
                        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0, 3, 0),
                        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, own, 2, 0),
                        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0 - own, 1, 0),
                        sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM),
                        sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
  const sock_fprog filter = {static_cast<unsigned short>(program.size()), program.data()};
  if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0) Filter::fail(errno, "signals");
}

}  // namespace

void forbid_calls(Reach reach, pid_t judge) {
  if (reach == Reach::kSignal) keep_signals_in();
  const Filter filter;
  for (const char* name : kForbidden) filter.forbid(name);
  for (const std::uint64_t flag : kNamespaces) {
    filter.forbid("clone", {{0, SCMP_CMP_MASKED_EQ, flag, flag}});
  }
  // The flags of clone3() are in memory, which filters cannot read. Libraries fall back to clone().
  filter.forbid("clone3", {}, ENOSYS);
  // Java's file functions need a pair of stream sockets, which can reach nothing else. Datagram
  // sockets could.
  filter.forbid("socketpair", {is_not(1, SOCK_STREAM)});
  for (const std::uint64_t command : {std::uint64_t{F_SETOWN}, kSetSignal, kSetOwnerOfKind}) {
    filter.forbid("fcntl", {is(1, command)});
  }
  for (const std::uint64_t request :
       {kSetOwnerOfStream, kSetGroupOfSocket, std::uint64_t{TIOCSTI}, std::uint64_t{TIOCLINUX}}) {
    filter.forbid("ioctl", {is(1, request)});
  }
  // raycheck must be able to inspect the process, to count its open files.
  filter.forbid("prctl", {is(0, PR_SET_DUMPABLE)});
  // The limit on file sizes does not apply to these modes, and they reserve disk space at once.
  for (const std::uint64_t mode :
       {std::uint64_t{FALLOC_FL_KEEP_SIZE}, std::uint64_t{FALLOC_FL_INSERT_RANGE}}) {
    filter.forbid("fallocate", {{1, SCMP_CMP_MASKED_EQ, mode, mode}}, EOPNOTSUPP);
  }
  for (const std::uint64_t request : kReserve) {
    filter.forbid("ioctl", {is(1, request)}, EOPNOTSUPP);
  }
  if (reach != Reach::kOwn) {
    for (const char* name : kOfAProcess) filter.forbid(name, {is_not(0, 0)});
    for (const OfAKind& call : kOfAKind) {
      filter.forbid(call.name, {is_not(1, 0)});
      filter.forbid(call.name, {is(0, call.user)});
    }
  }
  if (reach == Reach::kSignal) {
    for (const char* name : {"tkill", "pidfd_open", "pidfd_send_signal"}) filter.forbid(name);
    // The parent may be the supervisor.
    for (const pid_t one : {judge, getppid()}) {
      for (const char* name : {"tgkill", "rt_tgsigqueueinfo"}) {
        filter.forbid(name, {is(0, static_cast<std::uint64_t>(one))});
      }
    }
  }
  filter.load();
}

namespace {

namespace fs = std::filesystem;

/// landlock_ruleset_attr of kernels that are newer than these headers. Older kernels accept fields
/// that are zero.
struct Attributes {
  std::uint64_t files = 0, network = 0, scopes = 0;
};

// The versions of the Landlock ABI in which the kernel added these.
constexpr int kAbiRefer = 2, kAbiTruncate = 3, kAbiNetwork = 4, kAbiDevices = 5, kAbiScopes = 6;
constexpr std::uint64_t kFirstRights = (std::uint64_t{1} << 13) - 1;
constexpr std::uint64_t kRefer = std::uint64_t{1} << 13;
constexpr std::uint64_t kTruncate = std::uint64_t{1} << 14;
constexpr std::uint64_t kDevices = std::uint64_t{1} << 15;
constexpr std::uint64_t kBindAndConnect = 3;
constexpr std::uint64_t kAbstractSocketsAndSignals = 3;

constexpr std::uint64_t kReads =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
/// The rights that apply to files; all others apply only to folders.
constexpr std::uint64_t kOfFiles = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE |
                                   LANDLOCK_ACCESS_FS_READ_FILE | kTruncate | kDevices;

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), "landlock: " + what);
}

Attributes handled_by(int abi) {
  Attributes all;
  all.files = kFirstRights | (abi >= kAbiRefer ? kRefer : 0) |
              (abi >= kAbiTruncate ? kTruncate : 0) | (abi >= kAbiDevices ? kDevices : 0);
  all.network = abi >= kAbiNetwork ? kBindAndConnect : 0;
  all.scopes = abi >= kAbiScopes ? kAbstractSocketsAndSignals : 0;
  return all;
}

class Ruleset {
 public:
  explicit Ruleset(const Attributes& handled)
      : handled_(handled.files),
        rules_(
            static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0U))) {
    if (!rules_.is_open()) fail("rules");
  }

  void allow(const fs::path& path, std::uint64_t rights) const {
    const Descriptor of(open(path.c_str(), O_PATH | O_CLOEXEC));
    landlock_path_beneath_attr rule{};
    rule.parent_fd = of.number();
    rule.allowed_access = rights & handled_ & (fs::is_directory(path) ? ~0ULL : kOfFiles);
    if (!of.is_open() || syscall(SYS_landlock_add_rule, rules_.number(), LANDLOCK_RULE_PATH_BENEATH,
                                 &rule, 0U) != 0) {
      fail(path);
    }
  }

  /// Allows a path to be read. In a folder with hidden parts, allows all other entries one by one.
  void allow_reads(const fs::path& path, const std::vector<fs::path>& hidden) const {
    if (std::ranges::find(hidden, path) != hidden.end()) return;
    const std::string below = path.string() + "/";
    if (std::ranges::none_of(
            hidden, [&](const fs::path& one) { return one.string().starts_with(below); })) {
      allow(path, kReads);
      return;
    }
    allow(path, LANDLOCK_ACCESS_FS_READ_DIR);
    for (const auto& entry : fs::directory_iterator(path)) {
      if (!entry.is_symlink()) allow_reads(entry.path(), hidden);
    }
  }

  void enforce() const {
    if (syscall(SYS_landlock_restrict_self, rules_.number(), 0U) != 0) fail("beginning");
  }

 private:
  std::uint64_t handled_;
  Descriptor rules_;
};

}  // namespace

bool keep_to_files(const FileRights& rights) {
  const auto abi = static_cast<int>(
      syscall(SYS_landlock_create_ruleset, nullptr, 0UL, LANDLOCK_CREATE_RULESET_VERSION));
  if (abi < 1) fail("this kernel has no Landlock");
  const Ruleset rules(handled_by(abi));
  for (const fs::path& path : rights.reads) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    if (!error) rules.allow_reads(real, rights.hidden);
  }
  for (const fs::path& path : rights.writes) rules.allow(path, ~0ULL);
  rules.enforce();
  return abi >= kAbiScopes;
}

}  // namespace raycheck::tools
