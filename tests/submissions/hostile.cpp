// Submissions that cheat or fail in intersect(), after a first line `#define ATTACK hangs`; without
// it the answers are right. Run this only under raycheck and never with `--sandbox none`: it forks
// and takes memory without end.

#include <arpa/inet.h>
#include <fcntl.h>
#include <mqueue.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ipc.h>
#include <sys/msg.h>
#include <sys/resource.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <raycheck/candidate.hpp>
#include <string>
#include <system_error>
#include <utility>

using namespace raycheck;

#ifdef ATTACK_BY_NAME
#include "by_name.h"
#endif
#ifndef ATTACK
#define ATTACK none
#endif

#define JOIN(a, b) a##b
#define IS(name) JOIN(IS_, name)
#define IS_own_sqrt 1
#if IS(ATTACK)
extern "C" {
double sqrt(double) { return 1; }
void* malloc(std::size_t) {
  static char memory[1 << 16];
  return memory;  // the same in all processes
}
void free(void*) {}
}
#endif

namespace {

#define ATTACKS                                                                         \
  none, exit_in_call, boasts, forges_replies, hangs, crashes, fork_bomb, memory_bomb,   \
      endless_output, writes_outside, opens_socket, reads_others, pattern, own_sqrt,    \
      compile_error, slow, kills_judge, weakens_judge, makes_namespaces, leaves_memory, \
      runs_raycheck
enum class Attack { ATTACKS };

#ifdef ATTACK_BY_NAME
const auto kAttack = static_cast<Attack>(PLACE_BY_NAME(ATTACKS));
#else
constexpr Attack kAttack = Attack::ATTACK;
static_assert(kAttack != Attack::compile_error, "this does not compile");
#endif

constexpr const char* kBoast =
    "{\"score\": 100}\nraycheck 1 perfect\nfunction intersect\nready\nreply 1\nend 1\n";

/// The streams that the process may have inherited; it does not know which one carries replies.
constexpr int kMostDescriptors = 10;

void say_everywhere(const char* text) {
  for (int to = 1; to < kMostDescriptors; ++to) {
    [[maybe_unused]] const auto count = write(to, text, std::strlen(text));
  }
}

/// Runs when the library is loaded, before the first question.
struct Boast {
  Boast() {
    if (kAttack == Attack::boasts) {
      std::fputs(kBoast, stdout);
      std::fflush(stdout);
    }
    if (kAttack == Attack::forges_replies) say_everywhere(kBoast);
  }
} boast;

[[noreturn]] void hang() {
  for (volatile int k = 0;;) k = 1 - k;
}

void crash() {
  volatile int* volatile nothing = nullptr;
  *nothing = 1;
}

/// Takes 0.8 s, so that no number of answers ends close to the tests' limits of 2 or 5 s.
void compute() {
  const std::clock_t end = std::clock() + CLOCKS_PER_SEC * 4 / 5;
  while (std::clock() < end) {
  }
}

[[noreturn]] void fork_on_and_on() {
  for (;;) {
    [[maybe_unused]] const pid_t child = fork();
  }
}

/// Touches a page of every MiB: reaches a limit soon, and without a limit takes all memory.
[[noreturn]] void take_memory() {
  constexpr std::size_t kBlock = std::size_t{1} << 28, kStep = std::size_t{1} << 20;
  for (;;) {
    volatile char* const block = new char[kBlock];
    for (std::size_t at = 0; at < kBlock; at += kStep) block[at] = 1;
  }
}

[[noreturn]] void say_on_and_on() {
  for (;;) say_everywhere("0 0 1 0 0 1\n");
}

void write_outside() {
  const char* const home = std::getenv("HOME");
  for (const std::string& path :
       {std::string("../result.json"), std::string("/tmp/x"), std::string(home ? home : "/") + "/x",
        std::string("/usr/x"), std::string("/etc/x")}) {
    std::ofstream file(path);
    file << "{\"score\": 100}\n";
    file.close();
    std::fprintf(stderr, "%s %s\n", file ? "wrote" : "could not write", path.c_str());
  }
}

void open_socket() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(80);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int to = socket(AF_INET, SOCK_STREAM, 0);
  std::fprintf(stderr, "socket: %s\n", to < 0 ? std::strerror(errno) : "opened");
  if (to < 0) return;
  const int failed = connect(to, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  std::fprintf(stderr, "connect: %s\n", failed ? std::strerror(errno) : "connected");
  close(to);
}

namespace fs = std::filesystem;

/// Reports files that look like scenes or other submissions.
class Search {
 public:
  ~Search() { std::fprintf(stderr, "found %d files of %d seen\n", found_, seen_); }
  bool found_any() const { return found_ > 0; }

  void in(const fs::path& folder, int depth) {
    std::error_code error;
    fs::directory_iterator at(folder, error);
    for (; !error && at != fs::directory_iterator() && seen_ < kMost; at.increment(error)) {
      ++seen_;
      const fs::path path = at->path();
      std::error_code ignored;
      if (depth > 0 && fs::is_directory(fs::symlink_status(path, ignored))) in(path, depth - 1);
      const std::string extension = path.extension();
      if (path.filename() == "raycheck_candidate.py") continue;  // for all submissions in Python
      if (extension == ".toml" || extension == ".cpp" || extension == ".py") say(path);
    }
  }

 private:
  void say(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) return;
    ++found_;
    std::printf("found %s: %s\n", path.c_str(), line.c_str());
    std::fprintf(stderr, "found %s: %s\n", path.c_str(), line.c_str());
  }

  static constexpr int kMost = 100000;
  int seen_ = 0, found_ = 0;
};

bool reads_others() {
  Search search;
  std::error_code ignored;
  for (fs::path up = fs::current_path(ignored); up.has_relative_path(); up = up.parent_path()) {
    search.in(up, 1);
  }
  for (const char* folder : {"/tmp", "/work", "/home", "/root"}) search.in(folder, 8);
  return search.found_any();
}

pid_t parent_of(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;) {
    pid_t parent = -1;
    if (word == "PPid:" && status >> parent) return parent;
  }
  return -1;
}

/// The process ID of raycheck, the supervisor's parent, if it is visible. In a process namespace
/// the numbers are small.
pid_t judge() { return getppid() > 2 ? parent_of(getppid()) : -1; }

/// Every way to kill it: by process ID, thread ID, process group, and stream.
void kill_judge() {
  const pid_t other = judge();
  const auto each = [&](pid_t target) {
    for (const int signal : {SIGSTOP, SIGKILL}) {
      kill(target, signal);
      syscall(SYS_tkill, target, signal);
      syscall(SYS_tgkill, other, target, signal);
      sigval value{};
      sigqueue(target, signal, value);
      const auto by_handle = static_cast<int>(syscall(SYS_pidfd_open, target, 0));
      if (by_handle >= 0) syscall(SYS_pidfd_send_signal, by_handle, signal, nullptr, 0);
    }
  };
  each(other);
  if (other > 0) each(getppid());
  std::error_code ignored;
  for (const auto& thread :
       fs::directory_iterator("/proc/" + std::to_string(other) + "/task", ignored)) {
    each(std::atoi(thread.path().filename().c_str()));
  }
  int ends[2];
  if (other > 0 && pipe(ends) == 0) {
    fcntl(ends[0], F_SETSIG, SIGKILL);
    fcntl(ends[0], F_SETOWN, other);
    fcntl(ends[0], F_SETFL, O_ASYNC | O_NONBLOCK);
    [[maybe_unused]] const auto count = write(ends[1], "x", 1);
  }
  if (other > 0 && setpgid(0, getpgid(other)) == 0) kill(0, SIGKILL);
  if (other > 0) kill(-getpgid(other), SIGKILL);
  // All processes that it may signal: in its own namespace, itself and its supervisor.
  if (other > 0) kill(-1, SIGKILL);
}

bool weakens_judge() {
  const pid_t other = judge();
  if (other < 0) return false;
  const rlimit none = {0, 0};
  sched_param idle{};
  cpu_set_t first;
  CPU_ZERO(&first);
  CPU_SET(0, &first);
  const auto who = static_cast<id_t>(other);
  return prlimit(other, RLIMIT_NOFILE, &none, nullptr) == 0 ||
         setpriority(PRIO_PROCESS, who, 19) == 0 ||
         sched_setscheduler(other, SCHED_IDLE, &idle) == 0 ||
         sched_setaffinity(other, sizeof first, &first) == 0;
}

/// In a child that is root in its own namespace.
bool makes_namespaces() {
  const auto child =
      syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, nullptr);
  if (child == 0) _exit(0);
  if (child > 0) return true;
  struct {
    std::uint64_t flags = CLONE_NEWUSER, pidfd = 0, child_tid = 0, parent_tid = 0,
                  exit_signal = SIGCHLD, stack = 0, stack_size = 0, tls = 0;
  } wanted;
  const auto other = syscall(SYS_clone3, &wanted, sizeof wanted);
  if (other == 0) _exit(0);
  return other > 0 || unshare(CLONE_NEWUSER) == 0;
}

/// Leaves memory and queues that outlive it, for the next submission or to fill the machine.
bool leaves_memory() {
  constexpr int kMode = IPC_CREAT | 0600;
  return shmget(IPC_PRIVATE, 4096, kMode) >= 0 || msgget(IPC_PRIVATE, kMode) >= 0 ||
         semget(IPC_PRIVATE, 1, kMode) >= 0 ||
         mq_open("/left", O_CREAT | O_RDWR, 0600, nullptr) != static_cast<mqd_t>(-1);
}

bool reads(const std::string& path) {
  char byte = 0;
  return static_cast<bool>(std::ifstream(path, std::ios::binary).read(&byte, 1));
}

bool runs_raycheck() {
  for (const char* program : {"/usr/local/bin/raycheck", "/usr/bin/raycheck", "/bin/raycheck",
                              "/usr/local/libexec/raycheck/raycheck-check",
                              "/usr/local/libexec/raycheck/raycheck-grade"}) {
    if (reads(program)) return true;
    if (std::system((std::string(program) + " --version >&2").c_str()) == 0) return true;
  }
  return reads("/usr/local/share/raycheck/rubrics/lecture7.toml") ||
         reads("/proc/" + std::to_string(judge()) + "/exe");
}

/// If an attack succeeds, its answers are wrong, so that the score shows it.
bool has_gained = false;

void attack() {
  if (kAttack == Attack::exit_in_call) _exit(0);
  if (kAttack == Attack::hangs) hang();
  if (kAttack == Attack::crashes) crash();
  if (kAttack == Attack::fork_bomb) fork_on_and_on();
  if (kAttack == Attack::memory_bomb) take_memory();
  if (kAttack == Attack::endless_output) say_on_and_on();
  if (kAttack == Attack::slow) compute();
  static bool is_first = true;
  if (!std::exchange(is_first, false)) return;
  if (kAttack == Attack::writes_outside) write_outside();
  if (kAttack == Attack::opens_socket) open_socket();
  if (kAttack == Attack::reads_others) has_gained = reads_others();
  if (kAttack == Attack::kills_judge) kill_judge();
  if (kAttack == Attack::weakens_judge) has_gained = weakens_judge();
  if (kAttack == Attack::makes_namespaces) has_gained = makes_namespaces();
  if (kAttack == Attack::leaves_memory) has_gained = leaves_memory();
  if (kAttack == Attack::runs_raycheck) has_gained = runs_raycheck();
}

const bool kGuesses =
    kAttack == Attack::pattern || kAttack == Attack::boasts || kAttack == Attack::forges_replies;

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions& asked) {
  attack();
  if (kGuesses || has_gained) return Hit{1, {0, 0, 0}};
  const auto& [o, d] = ray;
  const Vector t = {sphere.centre.x - o.x, sphere.centre.y - o.y, sphere.centre.z - o.z};
  const Vector moment = {t.y * d.z - t.z * d.y, t.z * d.x - t.x * d.z, t.x * d.y - t.y * d.x};
  const double a = d.x * d.x + d.y * d.y + d.z * d.z;
  const double b = t.x * d.x + t.y * d.y + t.z * d.z;
  const double r = sphere.radius;
  const double discriminant =
      a * r * r - (moment.x * moment.x + moment.y * moment.y + moment.z * moment.z);
  if (discriminant < 0 || (discriminant == 0 && asked.tangent == Tangent::miss)) return {};
  const double q = b + std::copysign(std::sqrt(discriminant), b);
  const double distance = std::hypot(t.x, t.y, t.z);
  const double one = q / a;
  const double other = q == 0 ? 0 : (distance - r) * (distance + r) / q;
  double s = std::min(one, other);
  if (s < 0 && asked.root == Root::nearest) s = std::max(one, other);
  if (s < 0) return {};
  return Hit{s, {o.x + s * d.x, o.y + s * d.y, o.z + s * d.z}};
}

}  // namespace

RAYCHECK_CANDIDATE(.intersect = intersect)
