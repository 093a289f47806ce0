#include "tools/external/sandbox/process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <system_error>
#include <utility>

#include "scene/interruption.h"
#include "tools/external/sandbox/awake.h"
#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// At most this many successive reads of a stream, enough to empty a pipe. Endless output must not
/// keep raycheck from checking the time.
constexpr int kMostTurns = 64;

/// Microseconds between two checks whether a process has ended.
constexpr useconds_t kPause = 500;

/// Whether an error of read() or write() is not fatal: nothing can be transferred now, or the
/// stream is closed.
bool is_passing(int error) { return error == EAGAIN || error == EINTR || error == EPIPE; }

/// bubblewrap and shells turn a signal into an exit code above this one.
constexpr int kSignalled = 128;

/// The signal that killed a process; 0 if it exited.
int signal_of(int status) {
  if (WIFSIGNALED(status)) return WTERMSIG(status);
  const int code = WEXITSTATUS(status);
  return code > kSignalled && code <= kSignalled + SIGRTMAX ? code - kSignalled : 0;
}

double seconds_of(const timeval& time) {
  constexpr double kMicro = 1e-6;
  return static_cast<double>(time.tv_sec) + kMicro * static_cast<double>(time.tv_usec);
}

std::string words_left() {
  return fmt::format("its child processes could not be killed within {} s and may still run",
                     kMostEnding.count());
}

std::string file_limit_text(const Limits& limits) {
  return fmt::format("a file may have at most {} MiB{}", limits.file >> 20,
                     called(limits.names.file));
}

std::string reason_ended(int status, const Limits& limits) {
  const int signal = signal_of(status);
  // raycheck-jail itself was killed; otherwise it always exits with a code.
  if (WIFSIGNALED(status)) {
    return fmt::format(
        "lost its supervisor, which was killed by signal {} ({}): its child processes may still "
        "run",
        signal, strsignal(signal));
  }
  if (signal == 0) return fmt::format("exited with {}", WEXITSTATUS(status));
  const std::string killed = fmt::format("was killed by signal {} ({})", signal, strsignal(signal));
  if (signal == SIGXFSZ) return killed + ": " + file_limit_text(limits);
  if (signal == SIGXCPU) {
    return fmt::format("{}: it may use at most {} s of CPU time", killed, limits.cpu_seconds);
  }
  return killed;
}

}  // namespace

std::string last_line_text(const KeptText& error_output) {
  std::istringstream lines(error_output.text());
  std::string text, last;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) last = line;
    // After the reason, Java prints a stack trace, and Node the error's properties and its own
    // version.
    const bool is_reason = !line.empty() &&
                           std::string_view(" \t}").find(line[0]) == std::string_view::npos &&
                           !line.starts_with("Node.js v");
    if (is_reason) text = line;
  }
  if (text.empty()) text = last;
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  }
  return text.empty() ? "" : "; it printed: " + text;
}

std::string limit_text(const KeptText& error_output, const Limits& limits) {
  using Signs = std::vector<std::string_view>;
  const std::pair<std::string, Signs> rows[] = {
      {fmt::format("it may have at most {} processes and threads{}", limits.processes,
                   called(limits.names.processes)),
       {"can't start new thread", "unable to create native thread",
        "Resource temporarily unavailable"}},
      {fmt::format("it may use, and each of its processes reserve, at most {} MiB of memory{}",
                   limits.memory >> 20, called(limits.names.memory)),
       {"bad_alloc", "MemoryError", "OutOfMemoryError", "Cannot allocate memory", "out of memory",
        "Out of memory", "could not allocate memory"}},
      {file_limit_text(limits), {"File too large"}},
      {"it opens a window, and there is no display: it must draw without one, into a file",
       {"open display", "open X display", "open X11 display", "X11 connection", "$DISPLAY",
        "DISPLAY environment variable", "connect to display", "X11 window server",
        "HeadlessException", "No available video device"}}};
  const std::string text = error_output.text();
  for (const auto& [limit, signs] : rows) {
    if (std::ranges::any_of(
            signs, [&](std::string_view sign) { return text.find(sign) != std::string::npos; })) {
      return "; " + limit;
    }
  }
  return "";
}

std::string output_text(const std::string& output) {
  if (output.empty()) return "";
  return (output.find('\n') == std::string::npos ? "; it printed: " : "; it printed:\n") + output;
}

std::string Process::excerpt() const {
  return (error_output().empty() ? printed() : error_output()).excerpt();
}

Process::Process(const Confined& confined) try : confined_(confined) {
  // Without this, a candidate of the same user could read raycheck's memory.
  prctl(PR_SET_DUMPABLE, 0);
  signal(SIGPIPE, SIG_IGN);
  if (confined.layers.own_user) {
    user_ = next_user();
    const auto id = static_cast<uid_t>(user_);
    if (chown(folder_.path().c_str(), id, id) != 0) {
      throw std::system_error(errno, std::generic_category(), "its folder");
    }
  }
  if (confined.start) lay_out(*confined.start, folder_.path(), user_);
  StartingFolder given;
  given.files = confined.files;
  lay_out(given, folder_.path(), user_);
  if (confined.layers.control_group) group_.emplace(confined.layers, confined.limits);
  Pipe in, out, err;
  pid_ = launch(confined, folder_.path(), user_, group_ ? group_->path() : fs::path(),
                {in.read.number(), out.write.number(), err.write.number()});
  watch_.emplace(pid_, folder_.path(), confined_.limits, group_ ? &*group_ : nullptr,
                 has_neighbours());
  input_ = std::move(in.write);
  output_ = std::move(out.read);
  error_ = std::move(err.read);
  for (const Descriptor* end : {&input_, &output_, &error_}) {
    fcntl(end->number(), F_SETFL, O_NONBLOCK);
  }
} catch (const std::exception& error) {
  if (confined.surroundings) confined.surroundings->blame(error.what());
  throw ProcessFailure(FailureKind::kSystem, error.what());
}

Process::~Process() {
  if (!kill_all()) blame(FailureKind::kSystem, words_left());
}

/// Whether other candidates may run in parallel.
bool Process::has_neighbours() const {
  return confined_.surroundings && !confined_.surroundings->alone();
}

/// Whether it has ended by itself. Then all its processes have ended, unless raycheck-jail was
/// killed.
bool Process::has_ended(int& status) {
  rusage used{};
  if (wait4(pid_, &status, WNOHANG, &used) != pid_) return false;
  pid_ = -1;
  watch_->end(seconds_of(used.ru_utime) + seconds_of(used.ru_stime));
  listen(error_, error_output_);
  return true;
}

/// Kills all its processes; false if that failed.
bool Process::kill_all() {
  input_.close();
  bool is_done = true;
  if (pid_ > 0) {
    if (group_) group_->kill();
    is_done = end_supervised(pid_);
    pid_ = -1;
  }
  output_.close();
  error_.close();
  return is_done;
}

void Process::blame(FailureKind kind, const std::string& words) const {
  if (kind == FailureKind::kSystem && confined_.surroundings) confined_.surroundings->blame(words);
}

/// Charges the time since the last restart.
void Process::charge() { confined_.spent->add(watch_->taken()); }

/// Stops the process if it exceeds a limit.
void Process::look(const char* doing) {
  if (const auto stop = watch_->look(doing)) fail(stop->kind, stop->words);
}

void Process::fail(FailureKind kind, const std::string& words) {
  charge();
  const bool is_done = kill_all();
  const FailureKind of = is_done ? kind : FailureKind::kSystem;
  const std::string all = is_done ? words : words + "; " + words_left();
  blame(of, all);
  throw ProcessFailure(of, all);
}

/// Throws the failure of a process that ended abnormally.
void Process::fail_with(int status) {
  // This is the program's fault, even if the machine is short of memory.
  if (group_ && group_->has_met_memory_limit()) {
    fail(FailureKind::kEnded, memory_words(confined_.limits));
  }
  const std::string words = reason_ended(status, confined_.limits);
  const std::string lack = lack_of_room(folder_.path());
  if (!lack.empty()) fail(FailureKind::kSystem, words + ": " + lack);
  // raycheck did not kill it. Another candidate may have killed it, or the system if memory is
  // short. A program that kills itself will do so again when no other candidate runs.
  const bool is_killed = signal_of(status) == SIGKILL;
  fail(is_killed && has_neighbours() ? FailureKind::kSystem : FailureKind::kEnded, words);
}

void Process::fail_ended() {
  int status = 0;
  while (!has_ended(status)) {
    scene::poll();
    look("closed its output and did not end");
    usleep(kPause);
  }
  fail_with(status);
}

/// Reads available output of a stream into a buffer, valid until the next call. Empty if nothing is
/// available, or if the stream has ended; then it is closed.
std::string_view Process::heard_on(Descriptor& stream) {
  if (!stream.is_open()) return {};
  const ssize_t count = read(stream.number(), buffer_.data(), buffer_.size());
  if (count == 0) stream.close();
  if (count < 0 && !is_passing(errno)) fail(FailureKind::kSystem, std::strerror(errno));
  if (count <= 0) return {};
  watch_->hear();
  return {buffer_.data(), static_cast<std::size_t>(count)};
}

/// Reads all available output of a stream.
void Process::listen(Descriptor& stream, KeptText& to) {
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const std::string_view heard = heard_on(stream);
    if (heard.empty()) return;
    to.append(heard);
  }
}

std::string Process::exchange(std::string_view request,
                              const std::function<bool(std::string_view line)>& is_last,
                              std::size_t most_bytes) {
  if (pid_ < 0) throw ProcessFailure(FailureKind::kEnded, "has ended");
  watch_->restart();
  answer_.clear();
  std::size_t line_begin = 0, searched = 0;
  for (;;) {
    look("gave no reply");
    const auto left = watch_->until_next().count();
    scene::poll();
    std::array<pollfd, 3> streams = {{{output_.number(), POLLIN, 0},
                                      {error_.number(), POLLIN, 0},
                                      {request.empty() ? -1 : input_.number(), POLLOUT, 0}}};
    int ready = request.empty() ? poll_awake(streams.data(), streams.size()) : 0;
    if (ready == 0) ready = poll(streams.data(), streams.size(), static_cast<int>(left));
    if (ready < 0 && errno != EINTR) {
      fail(FailureKind::kSystem, std::strerror(errno));
    }
    if (streams[1].revents != 0) listen(error_, error_output_);
    if (streams[2].revents != 0) {
      const ssize_t count = write(input_.number(), request.data(), request.size());
      if (count > 0) request.remove_prefix(static_cast<std::size_t>(count));
      if (count < 0 && errno == EPIPE) request = {};  // it has closed its input
      if (count < 0 && !is_passing(errno)) fail(FailureKind::kSystem, std::strerror(errno));
    }
    if (streams[0].revents == 0) continue;
    answer_ += heard_on(output_);
    if (!output_.is_open()) fail_ended();
    for (std::size_t end; (end = answer_.find('\n', searched)) != std::string::npos;) {
      const std::string_view line = std::string_view(answer_).substr(line_begin, end - line_begin);
      line_begin = searched = end + 1;
      if (!is_last(line)) continue;
      if (line_begin != answer_.size())
        fail(FailureKind::kExtraOutput, "wrote more after its reply");
      charge();
      return std::exchange(answer_, {});
    }
    searched = answer_.size();
    if (answer_.size() > most_bytes) {
      fail(FailureKind::kExtraOutput, fmt::format("replied with more than {} bytes", most_bytes));
    }
  }
}

int Process::finish() {
  input_.close();
  for (;;) {
    scene::poll();
    int status = 0;
    const bool ended = has_ended(status);
    listen(error_, error_output_);
    listen(output_, printed_);
    if (ended) {
      if (signal_of(status) != 0) fail_with(status);
      // This counts whatever the exit code is, because some of its output may be missing.
      if (const std::string lack = lack_of_room(folder_.path()); !lack.empty()) {
        fail(FailureKind::kSystem, "ended when " + lack);
      }
      charge();
      return WEXITSTATUS(status);
    }
    look("did not end");
    usleep(kPause);
  }
}

}  // namespace raycheck::tools
