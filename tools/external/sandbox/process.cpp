#include "tools/external/sandbox/process.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "tools/report/version.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// How much of what a candidate says on the standard error is kept.
constexpr std::size_t kSaid = 4096;

/// A user for each process, which no account has: of this process and a number where such large ids
/// exist, else one of 16 bits.
std::atomic<bool> has_large_users = true;
std::uint64_t next_user() {
  static std::atomic<std::uint64_t> next = 0;
  const auto process = static_cast<std::uint64_t>(getpid());
  const std::uint64_t number = next++;
  if (has_large_users) return std::uint64_t{1} << 30 | process % (1 << 22) << 8 | number % 256;
  constexpr std::uint64_t kFirst = 61184, kCount = 4336;
  return kFirst + (process * 61 + number) % kCount;
}

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

/// Java would take more addresses than there are for one process.
constexpr const char* kJava =
    "JAVA_TOOL_OPTIONS=-Xmx512m -XX:+UseSerialGC -XX:ReservedCodeCacheSize=64m";

/// Of the system what programs need: of /etc the loader's and Java's files, and no others.
std::vector<std::string> system_paths() {
  std::vector<std::string> paths = {"/usr",
                                    "/bin",
                                    "/lib",
                                    "/lib64",
                                    "/etc/alternatives",
                                    "/etc/ld.so.cache",
                                    "/etc/ld.so.conf",
                                    "/etc/ld.so.conf.d"};
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/etc", ignored)) {
    if (entry.path().filename().string().starts_with("java")) paths.push_back(entry.path());
  }
  return paths;
}

std::vector<std::string> jailed(const Confined& confined, const fs::path& folder,
                                std::uint64_t user) {
  const std::string jail = helper("raycheck-jail");
  const Limits& limits = confined.limits;
  std::vector<std::string> arguments = {jail,
                                        fmt::format("cpu={}", limits.cpu_seconds),
                                        fmt::format("memory={}", limits.memory),
                                        fmt::format("file={}", limits.file),
                                        fmt::format("files={}", limits.files),
                                        fmt::format("processes={}", limits.processes)};
  const auto add = [&](std::initializer_list<std::string> more) {
    arguments.insert(arguments.end(), more);
  };
  if (user != 0) add({fmt::format("user={}", user)});
  if (confined.layers.bubblewrap) {
    add({"--", "bwrap", "--unshare-all", "--die-with-parent", "--new-session", "--dev", "/dev",
         "--proc", "/proc", "--tmpfs", "/tmp"});
    for (const std::string& system : system_paths()) add({"--ro-bind-try", system, system});
    add({"--ro-bind", jail, jail});
    add({"--ro-bind-try", adapters(), adapters()});
    for (const fs::path& path : confined.readable) add({"--ro-bind", path, path});
    add({"--bind", folder, folder, "--remount-ro", "/", "--chdir", folder});
    add({"--", jail});
  }
  if (confined.layers.seccomp) add({"seccomp=1"});
  add({"--"});
  arguments.insert(arguments.end(), confined.arguments.begin(), confined.arguments.end());
  return arguments;
}

/// Starts a program with these streams, in this folder, with next to no environment.
pid_t spawn(const std::vector<std::string>& arguments, const fs::path& folder, int input,
            int output, int error) {
  std::vector<std::string> environment = {"PATH=/usr/local/bin:/usr/bin:/bin",
                                          "HOME=" + folder.string(),
                                          "TMPDIR=" + folder.string(),
                                          "LANG=C.UTF-8",
                                          kJava,
                                          "PYTHONPATH=" + adapters().string()};
  std::vector<char*> argv, envp;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  for (std::string& entry : environment) envp.push_back(entry.data());
  argv.push_back(nullptr);
  envp.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, error, STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  // A group of its own from the start, and none of the signals that raycheck ignores or blocks.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  pid_t pid = -1;
  const int failed = posix_spawn(&pid, argv[0], &actions, &attributes, argv.data(), envp.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    throw ProcessFailure(
        fmt::format("{} cannot be started: {}", arguments[0], std::strerror(failed)));
  }
  return pid;
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

/// Whether `true` runs in these layers.
bool works(const Layers& layers) {
  try {
    Process process({{"/bin/true"}, {}, layers, {}});
    return process.finish() == 0;
  } catch (const ProcessFailure&) {
    return false;
  }
}

Layers found_by_trying() {
  Layers layers;
  if (geteuid() == 0) {
    layers.other_user = true;
    if (!works(layers)) has_large_users = false;
    if (!works(layers)) layers.other_user = false;
  }
  layers.seccomp = true;
  if (!works(layers)) layers.seccomp = false;
  layers.bubblewrap = true;
  if (!works(layers)) layers.bubblewrap = false;
  return layers;
}

}  // namespace

std::string Layers::text() const {
  std::string text;
  for (const auto& [has, name] :
       {std::pair(other_user, "other user"), std::pair(seccomp, "seccomp"),
        std::pair(bubblewrap, "bubblewrap")}) {
    if (has) text += (text.empty() ? "" : ", ") + std::string(name);
  }
  return text.empty() ? "limits only" : text;
}

const Layers& layers_that_work() {
  static const Layers layers = found_by_trying();
  return layers;
}

Layers chosen_layers(Sandbox sandbox) {
  if (sandbox == Sandbox::kNone) return {};
  const Layers& layers = layers_that_work();
  if (sandbox == Sandbox::kRequire && !(layers.seccomp && layers.bubblewrap)) {
    throw std::invalid_argument(
        fmt::format("--sandbox require: here works {} of other user, seccomp and bubblewrap (its "
                    "Debian package is bubblewrap)",
                    layers.text()));
  }
  return layers;
}

fs::path helper(const std::string& name) { return opened_copy(program_folder() / name); }

fs::path program_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

fs::path adapters() {
  const fs::path installed = program_folder().parent_path() / "share" / "raycheck";
  return opened_copy(
      fs::exists(installed) ? installed : fs::path(kSourceFolder) / "tools/external/sdk/adapters");
}

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
  if (confined.layers.other_user) {
    user_ = next_user();
    const auto id = static_cast<uid_t>(user_);
    if (chown(folder_.path().c_str(), id, id) != 0) throw ProcessFailure("chown of its folder");
  }
  for (const auto& [name, content] : confined.files) {
    const fs::path path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << content;
    if (user_ != 0 &&
        chown(path.c_str(), static_cast<uid_t>(user_), static_cast<gid_t>(user_)) != 0) {
      throw ProcessFailure("chown of its files");
    }
  }
  Pipe in, out, err;
  try {
    pid_ = spawn(jailed(confined, folder_.path(), user_), folder_.path(), in.read, out.write,
                 err.write);
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

void Process::fail(const std::string& what) {
  kill_all();
  throw ProcessFailure(what);
}

void Process::fail_ended() {
  // Its streams are closed: it ends soon, or does nothing that could be heard.
  const auto deadline = Clock::now() + std::chrono::seconds(1);
  int status = 0;
  while (!has_ended(status)) {
    if (Clock::now() > deadline) fail("closed its output");
    usleep(1000);
  }
  fail(reason_ended(status));
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
  if (pid_ < 0) throw ProcessFailure("has ended");
  const auto limit = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(confined_.limits.seconds));
  const auto deadline = Clock::now() + limit;
  std::string answer;
  std::size_t line_begin = 0, searched = 0;
  std::array<char, 65536> buffer{};
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) fail(fmt::format("{} {} s", kSilent, confined_.limits.seconds));
    std::array<pollfd, 3> streams = {
        {{output_, POLLIN, 0}, {error_, POLLIN, 0}, {request.empty() ? -1 : input_, POLLOUT, 0}}};
    if (poll(streams.data(), streams.size(), static_cast<int>(left)) < 0 && errno != EINTR) {
      fail(std::strerror(errno));
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
      if (line_begin != answer.size()) fail("said more than it was asked");
      return answer;
    }
    searched = answer.size();
    if (answer.size() > most_bytes)
      fail(fmt::format("replied with more than {} bytes", most_bytes));
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
      if (signalled) fail(reason_ended(status));
      return WEXITSTATUS(status);
    }
    if (Clock::now() > deadline) {
      fail(fmt::format("{} {} s", kEndless, confined_.limits.seconds));
    }
    usleep(500);
  }
}

}  // namespace raycheck::tools
