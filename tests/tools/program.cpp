#include "tests/tools/program.h"

#include <atomic>
#include <system_error>

namespace raycheck::tests {
namespace {

/// The prefix of this process's temporary files, which are removed when it ends.
class TemporaryNames {
 public:
  ~TemporaryNames() {
    if (process_ != getpid()) return;  // a child that exits
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(testing::TempDir(), error)) {
      if (!entry.path().filename().string().starts_with(prefix_)) continue;
      fs::remove_all(entry.path(), error);
    }
  }
  const std::string& prefix() const { return prefix_; }

 private:
  pid_t process_ = getpid();
  std::string prefix_ = "raycheck_" + std::to_string(getpid()) + "_";
};

/// Removes environment variables that change the program's behaviour.
const bool kIsAlone = [] {
  for (const char* name : {"GITHUB_ACTIONS", "NO_COLOR"}) unsetenv(name);
  return true;
}();

std::string temporary_path(const std::string& name) {
  static const TemporaryNames names;
  return testing::TempDir() + names.prefix() + name;
}

/// Sends SIGINT as soon as `when` is true; if `when` is null, never.
Outcome start(const std::string& program, const std::string& arguments,
              const std::function<bool()>& when = nullptr) {
  // Several threads may run programs at the same time.
  static std::atomic<int> started = 0;
  const std::string number = std::to_string(++started);
  const std::string out = temporary_path("out" + number), err = temporary_path("err" + number);
  const pid_t child =
      start_shell("exec '" + program + "' " + arguments + " >'" + out + "' 2>'" + err + "'");
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

Outcome ended(Outcome outcome, const std::string& arguments, std::optional<int> exit_code) {
  EXPECT_EQ(outcome.exit_code, exit_code.value_or(outcome.exit_code)) << arguments << "\n"
                                                                      << outcome.out << outcome.err;
  return outcome;
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

pid_t start_shell(const std::string& command) {
  const std::string there = "cd '" RAYCHECK_SOURCE_DIR "' && " + command;
  const pid_t child = fork();
  if (child != 0) return child;
  execl("/bin/sh", "sh", "-c", there.c_str(), static_cast<char*>(nullptr));
  _exit(127);
}

std::string behind(const std::string& label, const std::string& text) {
  const std::size_t at = text.find(label);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + label.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::string camera_text(std::int64_t width, std::int64_t height, double window, double depth) {
  std::ostringstream text;
  text.precision(17);
  text << "[camera]\neye = [0, 0, 0]\nlook_at = [0, 0, " << -depth
       << "]\nup = [0, 1, 0]\nnear = " << -depth;
  for (const char* side : {"left", "bottom"}) text << "\n" << side << " = " << -window;
  for (const char* side : {"right", "top"}) text << "\n" << side << " = " << window;
  text << "\nwidth = " << width << "\nheight = " << height << "\n";
  return text.str();
}

std::string ray_text(const std::string& origin, const std::string& direction) {
  return "[[ray]]\norigin = [" + origin + "]\ndirection = [" + direction + "]\n";
}

std::string sphere_text(const std::string& centre, const std::string& radius) {
  return "[[sphere]]\ncentre = [" + centre + "]\nradius = " + radius + "\n";
}

Outcome run(const std::string& arguments, std::optional<int> exit_code) {
  return ended(start(RAYCHECK_BINARY, arguments), arguments, exit_code);
}

json printed_json(const std::string& arguments, std::optional<int> exit_code) {
  return json::parse(run(arguments + " --format json", exit_code).out);
}

void expect_refused(const std::string& arguments, const std::string& why) {
  const Outcome outcome = run(arguments + " </dev/null", 2);
  EXPECT_TRUE(has(outcome.err, why)) << arguments;
  EXPECT_EQ(outcome.out, "") << arguments;
}

std::vector<std::string> all_commands() {
  const std::string help = run("--help").out;
  static const std::regex line("\n  ([a-z]+) ");
  std::vector<std::string> names;
  for (std::sregex_iterator
           at(help.begin() + static_cast<long>(help.find("Commands:")), help.end(), line),
       end;
       at != end; ++at) {
    names.push_back((*at)[1]);
  }
  EXPECT_GE(names.size(), 13u);
  std::sort(names.begin(), names.end());
  return names;
}

Variable::Variable(const char* name, const std::string& value) : name_(name) {
  if (const char* const before = std::getenv(name)) before_ = before;
  setenv(name, value.c_str(), 1);
}

Variable::~Variable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }

void expect_parts(const std::string& text, const std::vector<std::string>& parts, const char* file,
                  int line) {
  for (const std::string& part : parts) {
    if (!has(text, part)) ADD_FAILURE_AT(file, line) << part << "\nis not in\n" << text;
  }
}

json found(const json& list, const std::string& key, const json& value) {
  const auto at =
      std::find_if(list.begin(), list.end(), [&](const json& one) { return one[key] == value; });
  return at == list.end() ? json() : *at;
}

double number(const json& text) { return std::strtod(text.get<std::string>().c_str(), nullptr); }

void expect_values(const json& report, const json& values, const char* file, int line) {
  for (const auto& [path, value] : values.items()) {
    const json::json_pointer place("/" + path);
    const json found = report.contains(place) ? report.at(place) : json("(is not there)");
    if (found != value) ADD_FAILURE_AT(file, line) << path << ": " << found << ", not " << value;
  }
}

Outcome run_python(const std::string& arguments, std::optional<int> exit_code) {
  return ended(start("python3", arguments), arguments, exit_code);
}

Outcome run_bash(const std::string& script, std::optional<int> exit_code) {
  return ended(start("bash", quoted(temporary_file("script.sh", script))), script, exit_code);
}

bool eventually(const std::function<bool()>& holds) {
  for (int k = 0; k < 60000; ++k) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

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

std::string temporary_folder(const std::string& name) {
  static int count = 0;
  const std::string path = temporary_path(name + std::to_string(++count) + ".d");
  fs::create_directory(path);
  fs::permissions(path, fs::perms{0755});
  return path;
}

bool has_imagemagick() {
  static const bool has = run_bash("cd " + temporary_folder("imagemagick") +
                                   " && convert -size 8x8 xc:red o.exr && convert o.exr o.hdr")
                              .exit_code == 0;
  return has;
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

std::string resized_example(const std::string& name, int side) {
  static const std::regex size("(width|height) = [0-9]+");
  const std::string text = contents(RAYCHECK_SOURCE_DIR "/scene/examples/" + name);
  return temporary_file(std::to_string(side) + "_" + name,
                        std::regex_replace(text, size, "$1 = " + std::to_string(side)));
}

const std::string& compiled(const std::string& source) {
  static std::map<std::string, std::string> libraries;
  std::string& library = libraries[source];
  if (library.empty()) {
    library = temporary_file("compiled" + std::to_string(libraries.size()) + ".so", "");
    const std::string words = "cd '" RAYCHECK_SOURCE_DIR
                              "' && g++ -std=c++20 -O1 -fPIC -shared -Iinclude "
                              "-isystem /usr/include/eigen3 -o '" +
                              library + "' '" + source + "'";
    EXPECT_EQ(std::system(words.c_str()), 0) << words;
    library = "library:" + library;
  }
  return library;
}

std::string built_submission(const std::string& source, const std::string& name,
                             const std::string& folder) {
  const bool is_renderer = source.ends_with("rt.cpp");
  const std::string built = source.substr(0, source.find('.')) + (is_renderer ? "" : ".so");
  const fs::path copy = fs::path(folder) / (name + (is_renderer ? ".rt" : ".so"));
  fs::create_directories(folder);
  fs::copy_file(RAYCHECK_SUBMISSIONS "/" + built, copy);
  return copy.string();
}

}  // namespace raycheck::tests
