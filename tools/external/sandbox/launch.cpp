#include "tools/external/sandbox/launch.h"

#include <fmt/core.h>
#include <spawn.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <initializer_list>
#include <system_error>

#include "tools/external/sandbox/private_folder.h"
#include "tools/report/version.h"

namespace raycheck::tools {

namespace fs = std::filesystem;

namespace {

std::atomic<bool> has_large_users = true;

}  // namespace

void use_small_users() { has_large_users = false; }

std::uint64_t next_user() {
  static std::atomic<std::uint64_t> next = 0;
  const auto process = static_cast<std::uint64_t>(getpid());
  const std::uint64_t number = next++;
  if (has_large_users) return std::uint64_t{1} << 30 | process % (1 << 22) << 8 | number % 256;
  constexpr std::uint64_t kFirst = 61184, kCount = 4336;
  return kFirst + (process * 61 + number) % kCount;
}

fs::path helper(const std::string& name) { return readable_copy(program_folder() / name); }

fs::path program_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

fs::path adapters() {
  const fs::path installed = program_folder().parent_path() / "share" / "raycheck";
  return readable_copy(
      fs::exists(installed) ? installed : fs::path(kSourceFolder) / "tools/external/sdk/adapters");
}

namespace {

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

}  // namespace

pid_t launch(const Confined& confined, const fs::path& folder, std::uint64_t user,
             const Streams& streams) {
  const std::vector<std::string> arguments = jailed(confined, folder, user);
  std::vector<std::string> environment = {"PATH=" + std::string(kProgramPath),
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
  posix_spawn_file_actions_adddup2(&actions, streams.input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, streams.output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, streams.error, STDERR_FILENO);
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
    throw ProcessFailure(FailureKind::kSystem, fmt::format("{} cannot be started: {}", arguments[0],
                                                           std::strerror(failed)));
  }
  return pid;
}

}  // namespace raycheck::tools
