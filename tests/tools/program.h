// What tests of the built program are written with.
#pragma once

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>
#include <thread>

#include "tests/testing.h"

namespace raycheck::tests {

namespace fs = std::filesystem;
using nlohmann::json;

/// What a run of the built program left behind.
struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs `raycheck ARGUMENTS` by the shell, in the source folder; it may be asked for an exit code.
Outcome run(const std::string& arguments, std::optional<int> exit_code = {});

/// What it prints under --format json.
json printed_json(const std::string& arguments, std::optional<int> exit_code = {});

/// Runs it, and expects exit code 2, nothing but an error, and this in it.
void expect_refused(const std::string& arguments, const std::string& why);

/// The commands that --help lists, sorted.
std::vector<std::string> all_commands();

/// Runs `python3 ARGUMENTS` in the same way.
Outcome run_python(const std::string& arguments, std::optional<int> exit_code = {});

/// Runs a script by bash.
Outcome run_bash(const std::string& script, std::optional<int> exit_code = {});

/// A word for the shell, whatever it has.
std::string quoted(const std::string& text);
/// Starts a shell's command in the source folder, and does not wait for it.
pid_t start_shell(const std::string& command);

/// Waits until it holds, however busy the machine is; false where it does not within ten minutes.
bool eventually(const std::function<bool()>& holds);

/// Whether there is such a program here; where there is none, tests of it are skipped.
bool is_installed(const std::string& program);

/// Starts it, sends SIGINT once `when` holds, and waits for its end.
Outcome run_interrupted(const std::string& arguments, const std::function<bool()>& when);

/// Writes a file into the test's temporary folder and returns its path.
std::string temporary_file(const std::string& name, const std::string& text);

/// A new folder, which goes with the process; anyone may use it.
std::string temporary_folder(const std::string& name);
/// What is in a folder.
std::vector<std::string> names_in(const std::string& folder);
/// A file of an example scene whose picture has another number of pixels on each side.
std::string resized_example(const std::string& name, int side);

/// A candidate's source as library:PATH, compiled once for all tests of the process.
const std::string& compiled(const std::string& source);

/// A copy, in a folder, of a submission of tests/submissions (rays.cpp, hostile.cpp, rt.cpp, ...),
/// built, which does wrong what has this name there ("none": nothing); its path, NAME.so or
/// NAME.rt. single_rays.cpp and single_rt.cpp are the same in floats; right.cpp of tests/candidates
/// does nothing wrong, whatever it is called.
std::string built_submission(const std::string& source, const std::string& name,
                             const std::string& folder);

/// A variable of the environment is set, as long as this lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value);
  ~Variable();
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

/// What stands behind a label to the end of the line; empty where there is no such label.
std::string behind(const std::string& label, const std::string& text);

/// The start of a TOML scene: a camera at the origin that looks along -z at a window from -window
/// to window, near = -depth.
std::string camera_text(std::int64_t width, std::int64_t height, double window = 1,
                        double depth = 1);

/// A [[ray]] or [[sphere]] of a scene, of numbers with commas between them.
std::string ray_text(const std::string& origin, const std::string& direction);
std::string sphere_text(const std::string& centre, const std::string& radius);

/// The text has all of these.
void expect_parts(const std::string& text, const std::vector<std::string>& parts,
                  const char* file = __builtin_FILE(), int line = __builtin_LINE());
/// The first of a list that has this behind a key; null where there is none.
json found(const json& list, const std::string& key, const json& value);
/// A number as reports have it, hexadecimal.
double number(const json& text);
/// A report has these values behind its keys; "a/0/b" leads deeper.
void expect_values(const json& report, const json& values, const char* file = __builtin_FILE(),
                   int line = __builtin_LINE());

}  // namespace raycheck::tests
