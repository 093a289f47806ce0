#include "tools/candidates/process.h"

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
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <system_error>

#include "tools/version.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// How much of what a candidate says on the standard error is kept.
constexpr std::size_t kSaid = 4096;

/// Users that no account has (the range of systemd's dynamic users), one for each process.
constexpr std::uint64_t kFirstUser = 61184, kUsers = 4336;

std::uint64_t next_user() {
  static std::atomic<std::uint64_t> next = static_cast<std::uint64_t>(getpid()) * 61;
  return kFirstUser + next++ % kUsers;
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

/// Where the Python adapter is: beside an installed program, or in the sources it was built of.
fs::path adapters() {
  const fs::path installed = program_folder().parent_path() / "share" / "raycheck";
  return fs::exists(installed) ? installed : fs::path(kSourceFolder) / "tools/candidates/python";
}

std::vector<std::string> jailed(const Confined& confined, const fs::path& folder,
                                std::uint64_t user) {
  const std::string jail = program_folder() / "raycheck-jail";
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
    for (const char* system : {"/usr", "/bin", "/lib", "/lib64", "/etc"}) {
      add({"--ro-bind-try", system, system});
    }
    add({"--ro-bind", jail, jail});
    add({"--ro-bind-try", adapters(), adapters()});
    for (const fs::path& path : confined.readable) add({"--ro-bind", path, path});
    add({"--bind", folder, folder, "--chdir", folder});
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
                                          "HOME=" + folder.string(), "TMPDIR=" + folder.string(),
                                          "LANG=C.UTF-8", "PYTHONPATH=" + adapters().string()};
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

/// Kills what a user runs, until nothing is left: a process may have left its group.
void kill_all_of(std::uint64_t user) {
  for (bool found = true; found;) {
    found = false;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
      const std::string name = entry.path().filename();
      if (!std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; })) {
        continue;
      }
      struct stat status {};
      if (stat(entry.path().c_str(), &status) != 0 || status.st_uid != user) continue;
      const pid_t pid = std::stoi(name);
      // A child of ours that is dead only waits to be asked about.
      if (kill(pid, SIGKILL) == 0 && waitpid(pid, nullptr, WNOHANG) <= 0) {
        std::ifstream stat_file(entry.path() / "stat");
        const std::string line{std::istreambuf_iterator<char>(stat_file), {}};
        const std::size_t name_end = line.rfind(')');
        found = found || (name_end != std::string::npos && line.compare(name_end, 4, ") Z ") != 0);
      }
    }
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

bool others_may_read(const fs::path& path) {
  std::error_code error;
  const fs::perms own = fs::status(path, error).permissions();
  const fs::perms needed = fs::is_directory(path, error)
                               ? fs::perms::others_read | fs::perms::others_exec
                               : fs::perms::others_read;
  if (error || (own & needed) != needed) return false;
  for (fs::path folder = path.parent_path();; folder = folder.parent_path()) {
    const fs::perms perms = fs::status(folder, error).permissions();
    if (error || (perms & fs::perms::others_exec) == fs::perms::none) return false;
    if (folder == folder.root_path()) return true;
  }
}

Layers found_by_trying() {
  Layers layers;
  if (geteuid() == 0 && others_may_read(program_folder()) && others_may_read(adapters())) {
    layers.other_user = true;
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

Layers layers_for(Layers layers, const std::vector<fs::path>& readable) {
  layers.other_user =
      layers.other_user && std::all_of(readable.begin(), readable.end(), others_may_read);
  return layers;
}

fs::path program_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

PrivateFolder::PrivateFolder() {
  std::string name = fs::temp_directory_path() / "raycheck-XXXXXX";
  if (mkdtemp(name.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), name);
  }
  path_ = name;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
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

void Process::kill_all() {
  close_once(input_);
  if (pid_ > 0) {
    kill(-pid_, SIGKILL);
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
    if (user_ != 0) kill_all_of(user_);
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
  pid_t ended = 0;
  while ((ended = waitpid(pid_, &status, WNOHANG)) == 0 && Clock::now() < deadline) usleep(1000);
  listen();
  if (ended != pid_) fail("closed its output");
  const pid_t group = pid_;
  pid_ = -1;
  kill(-group, SIGKILL);
  if (user_ != 0) kill_all_of(user_);
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
    if (left <= 0) fail(fmt::format("gave no reply within {} s", confined_.limits.seconds));
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
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      listen();
      const pid_t group = pid_;
      pid_ = -1;
      kill(-group, SIGKILL);
      if (user_ != 0) kill_all_of(user_);
      if (WIFSIGNALED(status)) fail(reason_ended(status));
      return WEXITSTATUS(status);
    }
    if (Clock::now() > deadline) {
      fail(fmt::format("did not end within {} s", confined_.limits.seconds));
    }
    usleep(500);
  }
}

}  // namespace raycheck::tools
