#include <dlfcn.h>
#include <link.h>
#include <unistd.h>
#include <unwind.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <typeinfo>

#include "tools/external/protocol/frames.h"

namespace raycheck::tools {
namespace {

/// At most this many frames, of any library, are examined.
constexpr std::size_t kMostWalked = 256;
/// Unwinding takes some KiB.
constexpr std::size_t kAlternateStack = std::size_t{1} << 16;
constexpr std::array kDeadly = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT};

/// The library whose frames are reported.
const link_map* followed = nullptr;
int descriptor = -1;
/// The signal of the crash; 0 before it.
volatile std::sig_atomic_t deadly_signal = 0;

/// Frames of the library's code, the innermost first. Nothing here allocates memory, because signal
/// handlers use it.
struct Frames {
  std::array<std::uintptr_t, kMostFrames> offsets;
  std::size_t count, walked;

  void walk() {
    count = walked = 0;
    _Unwind_Backtrace([](_Unwind_Context* context,
                         void* frames) { return static_cast<Frames*>(frames)->add(context); },
                      this);
  }

 private:
  _Unwind_Reason_Code add(_Unwind_Context* context) {
    int is_at_fault = 0;
    std::uintptr_t address = _Unwind_GetIPInfo(context, &is_at_fault);
    // A return address lies after the call and may belong to the next line.
    if (is_at_fault == 0) --address;
    dl_find_object found{};
    if (followed != nullptr && _dl_find_object(reinterpret_cast<void*>(address), &found) == 0 &&
        found.dlfo_link_map == followed) {
      offsets[count++] = address - followed->l_addr;
    }
    return ++walked < kMostWalked && count < offsets.size() ? _URC_NO_REASON : _URC_END_OF_STACK;
  }
};
Frames of_death;

/// Builds the line with the frames, also without allocating memory.
class Line {
 public:
  explicit Line(const Frames& frames) {
    if (frames.count == 0) return;
    add(kFramesWord);
    for (std::size_t k = 0; k < frames.count; ++k) {
      add(" ");
      char* const at = text_.data() + size_;
      const auto written = std::to_chars(at, text_.data() + text_.size(), frames.offsets[k], 16);
      size_ += static_cast<std::size_t>(written.ptr - at);
    }
    add("\n");
  }
  std::string_view text() const { return {text_.data(), size_}; }

 private:
  void add(std::string_view more) {
    std::ranges::copy(more, text_.data() + size_);
    size_ += more.size();
  }
  std::array<char, kMostFramesLine> text_;
  std::size_t size_ = 0;
};

void on_death(int signal) {
  // If reading the frames crashes, too, the frames found so far are written.
  if (deadly_signal == 0) {
    deadly_signal = signal;
    of_death.walk();
  }
  const Line line(of_death);
  if (write(descriptor, line.text().data(), line.text().size()) < 0) {
    // The reader has closed the pipe.
  }
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, deadly_signal);
  std::signal(deadly_signal, SIG_DFL);
  sigprocmask(SIG_UNBLOCK, &one, nullptr);
  raise(deadly_signal);
}

/// Where the last exception of this thread was thrown.
struct Throw {
  const void* object;
  Frames frames;
};
thread_local Throw last_throw;

}  // namespace

void report_deaths(int to) {
  descriptor = to;
  alignas(std::max_align_t) static std::array<char, kAlternateStack> memory;
  stack_t stack{};
  stack.ss_sp = memory.data();
  stack.ss_size = memory.size();
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = on_death;
  action.sa_flags = SA_ONSTACK | SA_NODEFER;
  for (const int signal : kDeadly) sigaction(signal, &action, nullptr);
}

void follow(void* library) {
  link_map* loaded = nullptr;
  if (dlinfo(library, RTLD_DI_LINKMAP, static_cast<void*>(&loaded)) == 0) followed = loaded;
}

std::string frames_of_throw(const std::exception& error) {
  if (last_throw.object != dynamic_cast<const void*>(&error)) return {};
  return std::string(Line(last_throw.frames).text());
}

}  // namespace raycheck::tools

/// Replaces __cxa_throw of the C++ library, and calls it. When an exception is caught, its frames
/// are gone; here they still exist.
// NOLINTNEXTLINE(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp): the ABI's name.
extern "C" [[noreturn, gnu::visibility("default")]] void __cxa_throw(void* object,
                                                                     std::type_info* type,
                                                                     void (*destroy)(void*)) {
  using Throws = void (*)(void*, std::type_info*, void (*)(void*));
  static const auto next = reinterpret_cast<Throws>(dlsym(RTLD_NEXT, "__cxa_throw"));
  raycheck::tools::last_throw.object = object;
  raycheck::tools::last_throw.frames.walk();
  if (next != nullptr) next(object, type, destroy);
  std::abort();
}
