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

/// The outcome of running the built program.
struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs `raycheck ARGUMENTS` by the shell, in the source folder. If an exit code is given, expects
/// it.
Outcome run(const std::string& arguments, std::optional<int> exit_code = {});

/// The output of `raycheck ARGUMENTS --format json`.
json printed_json(const std::string& arguments, std::optional<int> exit_code = {});

/// Runs raycheck; expects exit code 2, an error message that contains this text, and no other
/// output.
void expect_refused(const std::string& arguments, const std::string& why);

/// The commands that --help lists, sorted.
std::vector<std::string> all_commands();

/// Runs `python3 ARGUMENTS` like run().
Outcome run_python(const std::string& arguments, std::optional<int> exit_code = {});

/// Runs a script by bash.
Outcome run_bash(const std::string& script, std::optional<int> exit_code = {});

/// A quoted word for the shell, with any characters.
std::string quoted(const std::string& text);
/// Starts a shell command in the source folder, without waiting for it.
pid_t start_shell(const std::string& command);

/// Waits until the condition holds; false if it does not hold within ten minutes.
bool eventually(const std::function<bool()>& holds);

/// Whether this program is installed. If not, tests with it are skipped.
bool is_installed(const std::string& program);
/// Whether ImageMagick is installed, with all formats that raycheck reads by it.
bool has_imagemagick();

/// Starts raycheck, sends SIGINT as soon as `when` is true, and waits for the end.
Outcome run_interrupted(const std::string& arguments, const std::function<bool()>& when);

/// Writes a file into the test's temporary folder and returns its path.
std::string temporary_file(const std::string& name, const std::string& text);

/// A new folder, accessible to all users, which is removed when the process ends.
std::string temporary_folder(const std::string& name);
/// The names of the entries of a folder.
std::vector<std::string> names_in(const std::string& folder);
/// Writes an example scene with this number of pixels on each side; returns the file's path.
std::string resized_example(const std::string& name, int side);

/// A candidate library:PATH, compiled from a source once for all tests of the process.
const std::string& compiled(const std::string& source);

/// Builds a submission of tests/submissions (rays.cpp, hostile.cpp, rt.cpp, ...) with the mistake
/// of this name ("none" for no mistake), and copies it to a folder; returns its path, NAME.so or
/// NAME.rt. single_rays.cpp and single_rt.cpp are versions in floats; right.cpp of tests/candidates
/// is always right.
std::string built_submission(const std::string& source, const std::string& name,
                             const std::string& folder);

/// Sets an environment variable as long as this object exists.
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

/// The text after a label, up to the end of the line; empty if the label is missing.
std::string behind(const std::string& label, const std::string& text);

/// The start of a TOML scene: a camera at the origin that looks along -z, with bounds from -window
/// to window and near = -depth.
std::string camera_text(std::int64_t width, std::int64_t height, double window = 1,
                        double depth = 1);

/// A [[ray]] or [[sphere]] of a scene, from numbers separated by commas.
std::string ray_text(const std::string& origin, const std::string& direction);
std::string sphere_text(const std::string& centre, const std::string& radius);

/// Expects that the text contains all these parts.
void expect_parts(const std::string& text, const std::vector<std::string>& parts,
                  const char* file = __builtin_FILE(), int line = __builtin_LINE());
/// The first object in a list that has this value under a key, or null.
json found(const json& list, const std::string& key, const json& value);
/// A hexadecimal number, as in reports.
double number(const json& text);
/// Expects that a report has these values under these keys; "a/0/b" is a path.
void expect_values(const json& report, const json& values, const char* file = __builtin_FILE(),
                   int line = __builtin_LINE());

}  // namespace raycheck::tests
