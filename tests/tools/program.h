// Helpers for tests of the built program.
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

/// The outcome of a run of the built program.
struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs `raycheck ARGUMENTS` by the shell, in the source folder; may expect an exit code.
Outcome run(const std::string& arguments, std::optional<int> exit_code = {});

/// Its output under --format json.
json printed_json(const std::string& arguments, std::optional<int> exit_code = {});

/// Runs it, and expects exit code 2 and only an error message that contains this.
void expect_refused(const std::string& arguments, const std::string& why);

/// The commands that --help lists, sorted.
std::vector<std::string> all_commands();

/// Runs `python3 ARGUMENTS` in the same way.
Outcome run_python(const std::string& arguments, std::optional<int> exit_code = {});

/// Runs a script by bash.
Outcome run_bash(const std::string& script, std::optional<int> exit_code = {});

/// A quoted word for the shell, with any characters.
std::string quoted(const std::string& text);
/// Starts a shell's command in the source folder, and does not wait for it.
pid_t start_shell(const std::string& command);

/// Waits until the condition holds; false if it does not within ten minutes.
bool eventually(const std::function<bool()>& holds);

/// Whether this program is installed; if not, tests of it are skipped.
bool is_installed(const std::string& program);

/// Starts it, sends SIGINT once `when` holds, and waits for its end.
Outcome run_interrupted(const std::string& arguments, const std::function<bool()>& when);

/// Writes a file into the test's temporary folder and returns its path.
std::string temporary_file(const std::string& name, const std::string& text);

/// A new folder, accessible to all users, which is removed when the process ends.
std::string temporary_folder(const std::string& name);
/// The contents of a folder.
std::vector<std::string> names_in(const std::string& folder);
/// A file of an example scene with this number of pixels on each side.
std::string resized_example(const std::string& name, int side);

/// A candidate's source as library:PATH, compiled once for all tests of the process.
const std::string& compiled(const std::string& source);

/// A copy, in a folder, of a submission of tests/submissions (rays.cpp, hostile.cpp, rt.cpp, ...),
/// built with the mistake of this name ("none": without); its path, NAME.so or NAME.rt.
/// single_rays.cpp and single_rt.cpp are the same in floats; right.cpp of tests/candidates is
/// always right.
std::string built_submission(const std::string& source, const std::string& name,
                             const std::string& folder);

/// Sets a variable of the environment during its lifetime.
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

/// The text after a label up to the end of the line; empty without that label.
std::string behind(const std::string& label, const std::string& text);

/// The start of a TOML scene: a camera at the origin that looks along -z at a window from -window
/// to window, near = -depth.
std::string camera_text(std::int64_t width, std::int64_t height, double window = 1,
                        double depth = 1);

/// A [[ray]] or [[sphere]] of a scene, from numbers separated by commas.
std::string ray_text(const std::string& origin, const std::string& direction);
std::string sphere_text(const std::string& centre, const std::string& radius);

/// Expects that the text contains all of these.
void expect_parts(const std::string& text, const std::vector<std::string>& parts,
                  const char* file = __builtin_FILE(), int line = __builtin_LINE());
/// The first object of a list that has this value under a key; or null.
json found(const json& list, const std::string& key, const json& value);
/// A hexadecimal number, as in reports.
double number(const json& text);
/// Expects that a report has these values under these keys; "a/0/b" is a path.
void expect_values(const json& report, const json& values, const char* file = __builtin_FILE(),
                   int line = __builtin_LINE());

}  // namespace raycheck::tests
