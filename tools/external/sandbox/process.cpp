#include "tools/external/sandbox/process.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// How much of what a candidate says on the standard error is kept.
constexpr std::size_t kSaid = 4096;

/// Both ends of a pipe, closed in other programs.
struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw std::system_error(errno, std::generic_category(), "pipe");
    }
    read = ends[0];
    write = ends[1];
  }
  int read = -1, write = -1;
};

void close_once(int& descriptor) {
  if (descriptor >= 0) close(descriptor);
  descriptor = -1;
}

/// Whether a process is dead and only waits to be asked about, or is gone.
bool is_dead(pid_t pid) {
  std::array<char, 512> text{};
  const int file = open(("/proc/" + std::to_string(pid) + "/stat").c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return true;
  const ssize_t size = read(file, text.data(), text.size());
  close(file);
  if (size <= 0) return true;
  const std::string_view line(text.data(), static_cast<std::size_t>(size));
  const std::size_t name_end = line.rfind(')');
  return name_end != std::string_view::npos && line.substr(name_end, 3) == ") Z";
}

/// Kills what a user runs, until nothing is left: a process may have left its group.
void kill_all_of(std::uint64_t user) {
  for (bool found = true; found;) {
    found = false;
    DIR* const processes = opendir("/proc");
    if (processes == nullptr) return;
    while (const dirent* const entry = readdir(processes)) {
      pid_t pid = 0;
      const std::string_view name = entry->d_name;
      const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), pid);
      if (error != std::errc() || end != name.data() + name.size()) continue;
      struct stat status {};
      if (stat(("/proc/" + std::string(name)).c_str(), &status) != 0 || status.st_uid != user) {
        continue;
      }
      if (kill(pid, SIGKILL) == 0) found = found || !is_dead(pid);
    }
    closedir(processes);
  }
}

/// bubblewrap and shells make of a signal an exit code above this one.
constexpr int kSignalled = 128;

std::string reason_ended(int status) {
  const bool exited = WIFEXITED(status);
  const int code = exited ? WEXITSTATUS(status) : 0;
  if (exited && (code <= kSignalled || code > kSignalled + SIGRTMAX)) {
    return fmt::format("exited with {}", code);
  }
  const int signal = exited ? code - kSignalled : WTERMSIG(status);
  return fmt::format("was killed by signal {} ({})", signal, strsignal(signal));
}

}  // namespace

std::string last_line_text(const std::string& said) {
  std::string text = said;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t line = text.rfind('\n');
  if (line != std::string::npos) text.erase(0, line + 1);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  }
  return text.empty() ? "" : "; it said: " + text;
}

Process::Process(const Confined& confined) : confined_(confined) {
  // What a candidate that runs as the same user could otherwise look into.
  prctl(PR_SET_DUMPABLE, 0);
  signal(SIGPIPE, SIG_IGN);
  if (confined.layers.own_user) {
    user_ = next_user();
    const auto id = static_cast<uid_t>(user_);
    if (chown(folder_.path().c_str(), id, id) != 0)
      throw ProcessFailure(FailureKind::kSystem, "chown of its folder");
  }
  for (const auto& [name, content] : confined.files) {
    const fs::path path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << content;
    if (user_ != 0 &&
        chown(path.c_str(), static_cast<uid_t>(user_), static_cast<gid_t>(user_)) != 0) {
      throw ProcessFailure(FailureKind::kSystem, "chown of its files");
    }
  }
  Pipe in, out, err;
  try {
    pid_ = launch(confined, folder_.path(), user_, {in.read, out.write, err.write});
  } catch (...) {
    for (int end : {in.read, in.write, out.read, out.write, err.read, err.write}) close(end);
    throw;
  }
  close(in.read);
  close(out.write);
  close(err.write);
  input_ = in.write;
  output_ = out.read;
  error_ = err.read;
  for (const int end : {input_, output_, error_}) fcntl(end, F_SETFL, O_NONBLOCK);
}

Process::~Process() { kill_all(); }

/// What a process may have left behind; with bubblewrap all that it started ends with it.
void Process::kill_rest(pid_t group) const {
  kill(-group, SIGKILL);
  if (user_ != 0 && !confined_.layers.bubblewrap) kill_all_of(user_);
}

/// Whether it has ended by itself; if so nothing of it is left.
bool Process::has_ended(int& status) {
  if (waitpid(pid_, &status, WNOHANG) != pid_) return false;
  listen();
  kill_rest(std::exchange(pid_, -1));
  return true;
}

void Process::kill_all() {
  close_once(input_);
  if (pid_ > 0) {
    kill(-pid_, SIGKILL);
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    kill_rest(std::exchange(pid_, -1));
  }
  close_once(output_);
  close_once(error_);
}

void Process::fail(FailureKind kind, const std::string& words) {
  kill_all();
  throw ProcessFailure(kind, words);
}

void Process::fail_ended() {
  // Its streams are closed: it ends soon, or does nothing that could be heard.
  const auto deadline = Clock::now() + std::chrono::seconds(1);
  int status = 0;
  while (!has_ended(status)) {
    if (Clock::now() > deadline) fail(FailureKind::kEnded, "closed its output");
    usleep(1000);
  }
  fail(FailureKind::kEnded, reason_ended(status));
}

/// Takes what there is on the standard error.
void Process::listen() {
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = error_ < 0 ? 0 : read(error_, buffer.data(), buffer.size());
    if (count == 0) close_once(error_);
    if (count <= 0) return;
    said_.append(buffer.data(), static_cast<std::size_t>(count));
    if (said_.size() > kSaid) said_.erase(0, said_.size() - kSaid);
    if (count < static_cast<ssize_t>(buffer.size())) return;
  }
}

std::string Process::exchange(std::string_view request,
                              const std::function<bool(std::string_view line)>& is_last,
                              std::size_t most_bytes) {
  if (pid_ < 0) throw ProcessFailure(FailureKind::kEnded, "has ended");
  const auto limit = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(confined_.limits.seconds));
  const auto deadline = Clock::now() + limit;
  std::string answer;
  std::size_t line_begin = 0, searched = 0;
  std::array<char, 65536> buffer{};
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) {
      fail(FailureKind::kTimeUp,
           fmt::format("gave no reply within {} s", confined_.limits.seconds));
    }
    std::array<pollfd, 3> streams = {
        {{output_, POLLIN, 0}, {error_, POLLIN, 0}, {request.empty() ? -1 : input_, POLLOUT, 0}}};
    if (poll(streams.data(), streams.size(), static_cast<int>(left)) < 0 && errno != EINTR) {
      fail(FailureKind::kSystem, std::strerror(errno));
    }
    if (streams[1].revents != 0) listen();
    if (streams[2].revents != 0) {
      const ssize_t count = write(input_, request.data(), request.size());
      if (count > 0) request.remove_prefix(static_cast<std::size_t>(count));
      if (count < 0 && errno != EAGAIN && errno != EINTR) request = {};  // it no longer reads
    }
    if (streams[0].revents == 0) continue;
    const ssize_t count = read(output_, buffer.data(), buffer.size());
    if (count == 0) fail_ended();
    if (count < 0) continue;
    answer.append(buffer.data(), static_cast<std::size_t>(count));
    for (std::size_t end; (end = answer.find('\n', searched)) != std::string::npos;) {
      const std::string_view line = std::string_view(answer).substr(line_begin, end - line_begin);
      line_begin = searched = end + 1;
      if (!is_last(line)) continue;
      if (line_begin != answer.size()) fail(FailureKind::kSaidMore, "said more than it was asked");
      return answer;
    }
    searched = answer.size();
    if (answer.size() > most_bytes) {
      fail(FailureKind::kSaidMore, fmt::format("replied with more than {} bytes", most_bytes));
    }
  }
}

int Process::finish() {
  close_once(input_);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(confined_.limits.seconds));
  std::array<char, 65536> ignored{};
  for (;;) {
    int status = 0;
    listen();
    while (read(output_, ignored.data(), ignored.size()) > 0) {
    }
    if (has_ended(status)) {
      const bool signalled = WIFSIGNALED(status) || WEXITSTATUS(status) > kSignalled;
      if (signalled) fail(FailureKind::kEnded, reason_ended(status));
      return WEXITSTATUS(status);
    }
    if (Clock::now() > deadline) {
      fail(FailureKind::kTimeUp, fmt::format("did not end within {} s", confined_.limits.seconds));
    }
    usleep(500);
  }
}

}  // namespace raycheck::tools
