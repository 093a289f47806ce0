#include "tools/terminal.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>

#include "scene/interruption.h"
#include "scene/text.h"

namespace raycheck::tools {
namespace {

std::atomic<int> first_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free, "set from a signal handler");

bool is_out = false;  ///< Whether something was written to standard output.

extern "C" void on_signal(int signal) {
  int none = 0;
  first_signal.compare_exchange_strong(none, signal);
  if (signal == SIGINT) std::signal(SIGINT, SIG_DFL);
}

/// The time to wait for the reader of standard output before checking for interrupts, and the
/// number of such waits after an interrupt.
constexpr int kWaitMilliseconds = 100;
constexpr int kMostWaits = 10;

/// Waits once; returns whether standard output is ready.
bool is_ready() {
  pollfd stream{STDOUT_FILENO, POLLOUT, 0};
  const int count = ::poll(&stream, 1, kWaitMilliseconds);
  if (count < 0 && errno != EINTR) throw std::runtime_error(std::strerror(errno));
  return count > 0;
}

}  // namespace

void hold_standard_streams() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    // open() returns the lowest free number.
    if (fcntl(descriptor, F_GETFD) < 0) open("/", O_PATH);
  }
}

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;  // without SA_RESTART: waits must see the flag
  struct sigaction before {};
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    sigaction(signal, nullptr, &before);
    if (signal == SIGHUP && before.sa_handler == SIG_IGN) continue;
    sigaction(signal, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
  // If a file may not grow, it is then reported as a file that cannot be written.
  std::signal(SIGXFSZ, SIG_IGN);
}
bool interrupted() { return first_signal != 0; }
int caught_signal() { return first_signal; }

bool has_written_out() { return is_out; }

bool stdout_takes_colours() {
  const char* no_color = std::getenv("NO_COLOR");
  return isatty(STDOUT_FILENO) != 0 && (no_color == nullptr || *no_color == '\0');
}

namespace {

void write_out(std::string_view text) {
  is_out = is_out || !text.empty();
  int waits = 0;
  while (!text.empty()) {
    if (!is_ready()) {
      waits = interrupted() ? waits + 1 : 0;
      if (waits > kMostWaits) throw scene::Interrupted{};
      continue;
    }
    // If a pipe is ready, this many bytes can be written without blocking.
    const ssize_t count =
        write(STDOUT_FILENO, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
      waits = 0;
    } else if (errno == EPIPE) {
      throw ClosedPipe{};
    } else if (errno != EINTR && errno != EAGAIN) {
      throw std::runtime_error(std::string("the report could not be written: ") +
                               std::strerror(errno));
    }
  }
}

/// The control sequences that begin and end a colour (red() in tools/report/words.h).
constexpr std::array<std::string_view, 2> kColours = {"\x1b[31m", "\x1b[0m"};

/// Like scene::visible, but keeps colours.
std::string visible_but_colours(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    std::size_t at = text.size();
    std::string_view colour;
    for (const std::string_view one : kColours) {
      const std::size_t found = std::min(text.find(one), text.size());
      if (found < at) {
        at = found;
        colour = one;
      }
    }
    shown += scene::visible(text.substr(0, at));
    shown += colour;
    text.remove_prefix(at + colour.size());
  }
  return shown;
}

/// In the log of a GitHub workflow, "::" at the start of a line and "##[" anywhere are commands
/// (docs/ci.md), so their first character is escaped.
std::string as_log_shows(const std::string& text) {
  if (std::getenv("GITHUB_ACTIONS") == nullptr) return text;
  std::string shown;
  bool begins = true;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const std::string_view rest = std::string_view(text).substr(k);
    const bool acts = (begins && rest.starts_with("::")) || rest.starts_with("##[");
    shown += acts ? fmt::format("\\x{:02x}", static_cast<unsigned char>(text[k]))
                  : std::string(1, text[k]);
    begins = text[k] == '\n' || (begins && (text[k] == ' ' || text[k] == '\t'));
  }
  return shown;
}

/// Shows the progress of long work, after the first second, in one line on standard error. If
/// standard error is not a terminal, prints a line for each finished part instead.
class ProgressLine {
 public:
  explicit ProgressLine(std::string_view what)
      : what_(scene::visible_line(what)),
        next_(std::chrono::steady_clock::now() + std::chrono::seconds(1)) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  void show(std::string_view state) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_ || isatty(STDERR_FILENO) == 0) return;
    std::fputs(fmt::format("\r\033[K{}: {}", what_, scene::visible_line(state)).c_str(), stderr);
    std::fflush(stderr);
    shown_ = true;
    next_ = now + std::chrono::milliseconds(200);
  }
  void list(std::string_view done) const {
    if (isatty(STDERR_FILENO) != 0) return;
    std::fputs(fmt::format("{}: {}\n", what_, scene::visible_line(done)).c_str(), stderr);
  }

 private:
  std::string what_;
  std::chrono::steady_clock::time_point next_;
  bool shown_ = false;
};

}  // namespace

void print_error(const std::string& text) {
  std::fputs(as_log_shows(scene::visible(text)).c_str(), stderr);
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) print_error(fmt::format("warning: {}\n", warning));
}

void print_report(const std::string& report, bool colours) {
  write_out(as_log_shows(colours ? visible_but_colours(report) : scene::visible(report)));
}

void print_commands(const std::string& commands) { write_out(scene::visible(commands)); }

properties::RunControl run_control(std::string what, int threads) {
  const auto shown = std::make_shared<ProgressLine>(std::move(what));
  return {interrupted, [shown](std::string_view state) { shown->show(state); },
          [shown](std::string_view done) { shown->list(done); }, threads};
}

}  // namespace raycheck::tools
