// Submissions that cheat or fail when they are asked to intersect, after a first line
// `#define ATTACK hangs`; without one it is right. To be run by raycheck alone, never with
// `--sandbox none`: it forks and takes memory without end.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <raycheck/candidate.hpp>
#include <string>
#include <system_error>
#include <thread>
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
  return memory;  // the same for all
}
void free(void*) {}
}
#endif

namespace {

#define ATTACKS                                                                       \
  none, exit_in_call, boasts, forges_replies, hangs, crashes, fork_bomb, memory_bomb, \
      endless_output, writes_outside, opens_socket, reads_others, pattern, own_sqrt,  \
      compile_error, slow
enum class Attack { ATTACKS };

#ifdef ATTACK_BY_NAME
const auto kAttack = static_cast<Attack>(PLACE_BY_NAME(ATTACKS));
#else
constexpr Attack kAttack = Attack::ATTACK;
static_assert(kAttack != Attack::compile_error, "this does not compile");
#endif

constexpr const char* kBoast =
    "{\"score\": 100}\nraycheck 1 perfect\nfunction intersect\nready\nreply 1\nend 1\n";

/// Of the streams that a process may have been given; which are replies it does not know.
constexpr int kMostDescriptors = 10;

void say_everywhere(const char* text) {
  for (int to = 1; to < kMostDescriptors; ++to) {
    [[maybe_unused]] const auto count = write(to, text, std::strlen(text));
  }
}

/// Runs when the library is loaded, before anything is asked.
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

[[noreturn]] void fork_on_and_on() {
  for (;;) {
    [[maybe_unused]] const pid_t child = fork();
  }
}

/// A page of every MiB is touched: that is soon at an end, and takes all there is without one.
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

/// Says what looks like a scene or like someone's submission.
class Search {
 public:
  ~Search() { std::fprintf(stderr, "found %d files of %d seen\n", found_, seen_); }

  void in(const fs::path& folder, int depth) {
    std::error_code error;
    fs::directory_iterator at(folder, error);
    for (; !error && at != fs::directory_iterator() && seen_ < kMost; at.increment(error)) {
      ++seen_;
      const fs::path path = at->path();
      std::error_code ignored;
      if (depth > 0 && fs::is_directory(fs::symlink_status(path, ignored))) in(path, depth - 1);
      const std::string extension = path.extension();
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

void read_others() {
  Search search;
  std::error_code ignored;
  for (fs::path up = fs::current_path(ignored); !up.empty(); up = up.parent_path()) {
    search.in(up, 1);
    if (up == up.root_path()) break;
  }
  for (const char* folder : {"/tmp", "/work", "/home", "/root"}) search.in(folder, 8);
}

void attack() {
  if (kAttack == Attack::exit_in_call) _exit(0);
  if (kAttack == Attack::hangs) hang();
  if (kAttack == Attack::crashes) crash();
  if (kAttack == Attack::fork_bomb) fork_on_and_on();
  if (kAttack == Attack::memory_bomb) take_memory();
  if (kAttack == Attack::endless_output) say_on_and_on();
  if (kAttack == Attack::slow) std::this_thread::sleep_for(std::chrono::milliseconds(200));
  static bool is_first = true;
  if (!std::exchange(is_first, false)) return;
  if (kAttack == Attack::writes_outside) write_outside();
  if (kAttack == Attack::opens_socket) open_socket();
  if (kAttack == Attack::reads_others) read_others();
}

const bool kGuesses =
    kAttack == Attack::pattern || kAttack == Attack::boasts || kAttack == Attack::forges_replies;

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions& asked) {
  attack();
  if (kGuesses) return Hit{1, {0, 0, 0}};
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
