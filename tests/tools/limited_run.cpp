#include "tests/tools/limited_run.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What is still there so long after its signal is killed; machines are loaded at times.
constexpr double kMostSecondsInAll = 120;

/// What a process and its threads have computed.
double cpu_seconds(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text, ')');  // its name
  for (int field = 3; field < 14; ++field) file >> text;
  double user = 0, system = 0;
  file >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Both ends of a pipe that no child inherits.
struct Pipe {
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe2");
  }
  ~Pipe() {
    close(ends[0]);
    close(ends[1]);
  }
  std::array<int, 2> ends{};
};

[[noreturn]] void become_program(const std::vector<std::string>& arguments,
                                 const Circumstances& how, int in, int out, int err) {
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  setenv("TMPDIR", how.stays_in.c_str(), 1);
  if (how.memory > 0) {
    const rlimit limit{how.memory, how.memory};
    setrlimit(RLIMIT_AS, &limit);
  }
  std::vector<char*> words;
  std::string program = RAYCHECK_BINARY;
  words.push_back(program.data());
  std::vector<std::string> copies = arguments;
  for (std::string& word : copies) words.push_back(word.data());
  words.push_back(nullptr);
  if (chdir(RAYCHECK_SOURCE_DIR) == 0) execv(program.c_str(), words.data());
  _exit(127);
}

/// Whether a process has begun to catch SIGTERM: a loaded machine takes its time to load a program.
bool catches_signals(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("SigCgt:", 0) != 0) continue;
    return (std::stoull(line.substr(7), nullptr, 16) >> (SIGTERM - 1) & 1) != 0;
  }
  return false;
}

}  // namespace

TestFolder::TestFolder() {
  std::string name = testing::TempDir() + "raycheck_XXXXXX";
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp");
  path_ = name;
  fs::permissions(path_, fs::perms::all);
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> TestFolder::names() const {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(path_)) {
    found.push_back(entry.path().filename().string());
  }
  return found;
}

LimitedOutcome run_limited(const std::vector<std::string>& arguments, const Circumstances& how) {
  const TestFolder folder;
  const std::string out = folder.path() / "out", err = folder.path() / "err";
  const Pipe input, stalled;
  const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const pid_t child = fork();
  if (child == 0) {
    become_program(arguments, how, input.ends[0], how.stalled ? stalled.ends[1] : out_file,
                   err_file);
  }
  close(out_file);
  close(err_file);
  LimitedOutcome outcome;
  int status = 0;
  pid_t ended = 0;
  const auto wait_until = [&](const auto& is_so, double most_seconds) {
    for (const auto start = Clock::now();
         ended == 0 && !is_so() && seconds_since(start) < most_seconds;) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ended = waitpid(child, &status, WNOHANG);
    }
  };
  if (how.signal != 0) {
    wait_until([&] { return outcome.caught = catches_signals(child); }, kMostSecondsInAll);
    wait_until([] { return false; }, how.signal_after);
  }
  const double before = cpu_seconds(child);
  if (how.signal != 0 && ended == 0) {
    outcome.was_signalled = true;
    kill(child, how.signal);
  }
  const auto note_time = [&] {
    outcome.seconds_after = cpu_seconds(child) - before;
    return false;
  };
  wait_until(note_time, kMostSecondsInAll);
  if (ended == 0) {
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
  }
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  outcome.out = contents(out);
  outcome.err = contents(err);
  return outcome;
}

}  // namespace raycheck::tests
