// Loaded before the C library (LD_PRELOAD): counts the system calls of a program by name, and fails
// one of them once.
//   RAYCHECK_FAULT=NAME:K:ERRNO     the K-th call of this name, from 0, fails with this number
//   RAYCHECK_FAULT_COUNTS=FILE      takes, at the end, a line "NAME COUNT K..." for each name: K is
//                                   the number of the first call from each place in the program
//   RAYCHECK_THROW=K                the K-th operation on enclosures, from 0, throws an exception,
//                                   as a bug in raycheck would
// Child processes have another environment, and no faults.

#include <dirent.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string_view>

namespace {

constexpr std::array kNames = {"open",    "openat",      "fopen",    "read",   "write", "writev",
                               "pipe2",   "mkdir",       "mkdtemp",  "rename", "poll",  "waitpid",
                               "opendir", "posix_spawn", "sendfile", "chown"};
std::array<std::atomic<long>, kNames.size()> counts;

constexpr std::size_t index_of(std::string_view name) {
  std::size_t k = 0;
  while (kNames[k] != name) ++k;
  return k;
}

/// The place of a call: this function, the wrapper of the call, and its callers.
using Place = std::array<void*, 6>;
/// Exists before other libraries' constructors make calls, and is never destroyed: threads make
/// calls while the program ends.
std::array<std::map<Place, long>, kNames.size()>& first_calls() {
  static auto& all = *new std::array<std::map<Place, long>, kNames.size()>;
  return all;
}

void note_place(std::size_t which, long count) {
  static std::mutex mutex;
  static thread_local bool is_noting = false;
  if (std::getenv("RAYCHECK_FAULT_COUNTS") == nullptr || is_noting) return;
  is_noting = true;  // calls of this function are not counted
  Place place{};
  backtrace(place.data(), place.size());
  const std::lock_guard lock(mutex);
  first_calls()[which].emplace(place, count);
  is_noting = false;
}

/// Whether this call is the one that fails; errno is set then.
bool fails(std::size_t which) {
  static const bool is_tried = std::strcmp(program_invocation_short_name, "raycheck") == 0;
  if (!is_tried) return false;
  const long count = counts[which]++;
  note_place(which, count);
  static const char* const fault = std::getenv("RAYCHECK_FAULT");
  if (fault == nullptr) return false;
  std::array<char, 32> name{};
  long position = 0;
  int error = 0;
  if (std::sscanf(fault, "%31[a-z0-9_]:%ld:%d", name.data(), &position, &error) != 3) return false;
  if (count != position || std::strcmp(name.data(), kNames[which]) != 0) return false;
  errno = error;
  return true;
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

struct AtTheEnd {
  ~AtTheEnd() {
    const char* const path = std::getenv("RAYCHECK_FAULT_COUNTS");
    if (path == nullptr || std::strcmp(program_invocation_short_name, "raycheck") != 0) return;
    std::FILE* const file = next<std::FILE* (*)(const char*, const char*)>("fopen")(path, "w");
    if (file == nullptr) return;
    for (std::size_t k = 0; k < kNames.size(); ++k) {
      std::fprintf(file, "%s %ld", kNames[k], counts[k].load());
      for (const auto& [place, count] : first_calls()[k]) std::fprintf(file, " %ld", count);
      std::fputs("\n", file);
    }
    std::fclose(file);
  }
};
const AtTheEnd at_the_end;

}  // namespace

#define RAYCHECK_FAULTY(result, name, counted, failed, parameters, ...) \
  extern "C" result name parameters {                                   \
    constexpr std::size_t which = index_of(counted);                    \
    if (fails(which)) return failed;                                    \
    static const auto real = next<result(*) parameters>(#name);         \
    return real(__VA_ARGS__);                                           \
  }

// With the mode, which counts only if a file is created.
#define RAYCHECK_FAULTY_OPEN(name, counted, parameters, ...)      \
  extern "C" int name(RAYCHECK_LIST parameters, int flags, ...) { \
    va_list more;                                                 \
    va_start(more, flags);                                        \
    const mode_t mode = va_arg(more, mode_t);                     \
    va_end(more);                                                 \
    if (fails(index_of(counted))) return -1;                      \
    using Real = int (*)(RAYCHECK_LIST parameters, int, ...);     \
    static const auto real = next<Real>(#name);                   \
    return real(__VA_ARGS__, flags, mode);                        \
  }
#define RAYCHECK_LIST(...) __VA_ARGS__

RAYCHECK_FAULTY_OPEN(open, "open", (const char* path), path)
RAYCHECK_FAULTY_OPEN(open64, "open", (const char* path), path)
RAYCHECK_FAULTY_OPEN(openat, "openat", (int folder, const char* path), folder, path)
RAYCHECK_FAULTY_OPEN(openat64, "openat", (int folder, const char* path), folder, path)
RAYCHECK_FAULTY(std::FILE*, fopen, "fopen", nullptr, (const char* path, const char* mode), path,
                mode)
RAYCHECK_FAULTY(std::FILE*, fopen64, "fopen", nullptr, (const char* path, const char* mode), path,
                mode)
RAYCHECK_FAULTY(ssize_t, read, "read", -1, (int file, void* to, size_t size), file, to, size)
RAYCHECK_FAULTY(ssize_t, write, "write", -1, (int file, const void* from, size_t size), file, from,
                size)
RAYCHECK_FAULTY(ssize_t, writev, "writev", -1, (int file, const iovec* from, int count), file, from,
                count)
RAYCHECK_FAULTY(int, pipe2, "pipe2", -1, (int* ends, int flags), ends, flags)
RAYCHECK_FAULTY(int, mkdir, "mkdir", -1, (const char* path, mode_t mode), path, mode)
RAYCHECK_FAULTY(char*, mkdtemp, "mkdtemp", nullptr, (char* path), path)
RAYCHECK_FAULTY(int, rename, "rename", -1, (const char* from, const char* to), from, to)
RAYCHECK_FAULTY(int, poll, "poll", -1, (pollfd * files, nfds_t count, int milliseconds), files,
                count, milliseconds)
RAYCHECK_FAULTY(pid_t, waitpid, "waitpid", -1, (pid_t pid, int* status, int options), pid, status,
                options)
RAYCHECK_FAULTY(DIR*, opendir, "opendir", nullptr, (const char* path), path)
RAYCHECK_FAULTY(DIR*, fdopendir, "opendir", nullptr, (int folder), folder)
RAYCHECK_FAULTY(int, posix_spawn, "posix_spawn", errno,
                (pid_t * pid, const char* path, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const arguments[],
                 char* const environment[]),
                pid, path, actions, attributes, arguments, environment)
RAYCHECK_FAULTY(ssize_t, sendfile, "sendfile", -1, (int to, int from, off_t* at, size_t size), to,
                from, at, size)
RAYCHECK_FAULTY(ssize_t, sendfile64, "sendfile", -1, (int to, int from, off64_t* at, size_t size),
                to, from, at, size)
RAYCHECK_FAULTY(int, chown, "chown", -1, (const char* path, uid_t user, gid_t group), path, user,
                group)

namespace {

void may_throw() {
  static std::atomic<long> count{0};
  static const char* const position = std::getenv("RAYCHECK_THROW");
  if (position == nullptr || std::strcmp(program_invocation_short_name, "raycheck") != 0) return;
  if (count++ == std::atol(position)) throw std::out_of_range("injected");
}

}  // namespace

#define RAYCHECK_THROWING(name)                                                            \
  extern "C" void name(void* z, const void* x, const void* y, long precision) {            \
    may_throw();                                                                           \
    static const auto real = next<void (*)(void*, const void*, const void*, long)>(#name); \
    real(z, x, y, precision);                                                              \
  }

RAYCHECK_THROWING(arb_add)
RAYCHECK_THROWING(arb_sub)
RAYCHECK_THROWING(arb_mul)
RAYCHECK_THROWING(arb_div)
