#include "tests/tools/limited_run.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace raycheck::tests {
namespace {

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

LimitedOutcome run_limited(const std::vector<std::string>& arguments, const Circumstances& how) {
  const std::string folder = temporary_folder("limited");
  const std::string out = folder + "/out", err = folder + "/err", pipe = folder + "/pipe";
  if (mkfifo(pipe.c_str(), 0600) != 0) throw std::runtime_error("mkfifo");
  std::string line = "export TMPDIR=" + quoted(how.stays_in) + "; ";
  if (how.memory > 0) line += "ulimit -v " + std::to_string(how.memory / 1024) + "; ";
  line += "exec '" RAYCHECK_BINARY "'";
  for (const std::string& word : arguments) line += " " + quoted(word);
  // A pipe that is open at both ends has no end, and takes little.
  const pid_t child = start_shell(line + " <>'" + pipe + "' " +
                                  (how.stalled ? "1<>'" + pipe : ">'" + out) + "' 2>'" + err + "'");
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
