#include "tools/terminal.h"

#include <fmt/core.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

namespace raycheck::tools {
namespace {

std::atomic<bool> interrupt_flag = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

extern "C" void on_interrupt(int signal) {
  interrupt_flag = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}
bool interrupted() { return interrupt_flag; }

bool stdout_takes_colours() {
  const char* no_color = std::getenv("NO_COLOR");
  return isatty(STDOUT_FILENO) != 0 && (no_color == nullptr || *no_color == '\0');
}

Progress::Progress(std::string what)
    : what_(std::move(what)), next_(std::chrono::steady_clock::now() + std::chrono::seconds(1)) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::string_view state) {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_ || isatty(STDERR_FILENO) == 0) return;
  std::fputs(fmt::format("\r\033[K{}: {}", what_, state).c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
  next_ = now + std::chrono::milliseconds(200);
}

properties::RunControl run_control(std::string what, int threads) {
  catch_interrupts();
  const auto shown = std::make_shared<Progress>(std::move(what));
  return {interrupted, [shown](std::string_view state) { shown->show(state); }, threads};
}

}  // namespace raycheck::tools
