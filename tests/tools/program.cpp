#include "tests/tools/program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <thread>

namespace raycheck::tests {
namespace {

/// What the names of this process's temporary files begin with. They are removed when it ends.
class TemporaryNames {
 public:
  ~TemporaryNames() {
    if (process_ != getpid()) return;  // a child that exits
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(testing::TempDir(), error)) {
      if (!entry.path().filename().string().starts_with(prefix_)) continue;
      std::filesystem::remove_all(entry.path(), error);
    }
  }
  const std::string& prefix() const { return prefix_; }

 private:
  pid_t process_ = getpid();
  std::string prefix_ = "raycheck_" + std::to_string(getpid()) + "_";
};

/// What the program is told by its surroundings, it is told by tests alone.
const bool kIsAlone = [] {
  for (const char* name : {"GITHUB_ACTIONS", "NO_COLOR"}) unsetenv(name);
  return true;
}();

std::string temporary_path(const std::string& name) {
  static const TemporaryNames names;
  return testing::TempDir() + names.prefix() + name;
}

/// `when`: SIGINT is sent once it holds; null: none is.
Outcome start(const std::string& program, const std::string& arguments,
              const std::function<bool()>& when = nullptr) {
  const std::string out = temporary_path("out");
  const std::string err = temporary_path("err");
  const std::string command = std::string("cd '") + RAYCHECK_SOURCE_DIR + "' && exec '" + program +
                              "' " + arguments + " >'" + out + "' 2>'" + err + "'";
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  bool has_ended = false;
  if (when) {
    while (!when() && !has_ended) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      has_ended = waitpid(child, &status, WNOHANG) == child;
    }
    if (!has_ended) kill(child, SIGINT);
  }
  if (!has_ended) waitpid(child, &status, 0);
  Outcome result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  result.out = contents(out);
  result.err = contents(err);
  std::remove(out.c_str());
  std::remove(err.c_str());
  return result;
}

}  // namespace

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Variable::Variable(const char* name, const std::string& value) : name_(name) {
  if (const char* const before = std::getenv(name)) before_ = before;
  setenv(name, value.c_str(), 1);
}

Variable::~Variable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts, const char* file,
                  int line) {
  for (const std::string& part : parts) {
    if (!contains(text, part)) ADD_FAILURE_AT(file, line) << part << "\nis not in\n" << text;
  }
}

Outcome run(const std::string& arguments) { return start(RAYCHECK_BINARY, arguments); }

Outcome run_python(const std::string& arguments) { return start("python3", arguments); }

Outcome run_bash(const std::string& path) { return start("bash", "'" + path + "'"); }

bool is_installed(const std::string& program) {
  return std::system(("command -v '" + program + "' >/dev/null").c_str()) == 0;
}

Outcome run_interrupted(const std::string& arguments, const std::function<bool()>& when) {
  return start(RAYCHECK_BINARY, arguments, when);
}

std::string temporary_file(const std::string& name, const std::string& text) {
  const std::string path = temporary_path(name);
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string built_submission(const std::string& source, const std::string& name,
                             const std::string& folder) {
  const bool is_renderer = source.ends_with("rt.cpp");
  const std::string built = source.substr(0, source.find('.')) + (is_renderer ? "" : ".so");
  const std::filesystem::path copy =
      std::filesystem::path(folder) / (name + (is_renderer ? ".rt" : ".so"));
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(RAYCHECK_SUBMISSIONS "/" + built, copy);
  return copy.string();
}

}  // namespace raycheck::tests
