#include "tools/external/compile.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "tools/external/sandbox/file_tree.h"
#include "tools/report/version.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kCompilerProcesses = 256;
constexpr std::uint64_t kCompilerFiles = 256;
constexpr std::uint64_t kCompilerFile = std::uint64_t{256} << 20;
constexpr std::size_t kMostRules = std::size_t{16} << 20;
constexpr std::uintmax_t kMostBuilt = std::uintmax_t{256} << 20;
/// Only line tables, which are needed to find the line where a candidate crashes (source_lines.h).
constexpr const char* kLineTables = "-g1";
constexpr const char* kEigen = "/usr/include/eigen3";

std::vector<fs::path> files_in(const fs::path& folder, std::string_view extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (fs::is_regular_file(entry.symlink_status()) && entry.path().extension() == extension) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

/// A source's folder, and those below it that usually have headers.
std::vector<fs::path> header_folders(const fs::path& folder) {
  std::vector<fs::path> found = {folder};
  for (const char* name : {"include", "inc", "headers", "src", "source"}) {
    if (fs::is_directory(folder / name)) found.push_back(folder / name);
  }
  return found;
}

/// Copies a file that a sandboxed program made. Refuses links, because they may lead to files that
/// the program may not read.
fs::path copied(const fs::path& made, const fs::path& to) {
  if (!fs::is_regular_file(fs::symlink_status(made))) {
    throw CandidateError(fmt::format("{} is not a file", made.filename().string()));
  }
  fs::copy_file(made, to / made.filename());
  return to / made.filename();
}

/// The files in a source's folder that the compiler read, according to its make rules (-MMD).
std::set<std::string> read_of(const fs::path& folder, const fs::path& made) {
  const std::string within = folder.string() + "/";
  std::set<std::string> read;
  for (const fs::path& rules : files_in(made, ".d")) {
    const std::string text = file_bytes(rules, kMostRules) + " ";
    std::string word;
    for (std::size_t k = 0; k + 1 < text.size(); ++k) {
      const char c = text[k], next = text[k + 1];
      const bool is_escaped = (c == '\\' && next != '\n') || (c == '$' && next == '$');
      const bool is_between = c == ' ' || c == '\n' || (c == '\\' && !is_escaped);
      if (is_escaped) ++k;
      if (!is_between) word += text[k];
      if (!is_between && k + 2 < text.size()) continue;
      if (word.starts_with(within)) read.insert(word.substr(within.size()));
      word.clear();
    }
  }
  return read;
}

/// A build step that must succeed; `name` is its name in errors. Its output folder exists as long
/// as this object.
class BuildStep {
 public:
  BuildStep(const std::string& name, const Confined& confined, std::string* said = nullptr)
      : process_(confined) {
    std::string failure;
    try {
      const int code = process_.finish();
      if (code != 0) failure = fmt::format("exited with {}", code);
    } catch (const ProcessFailure& error) {
      failure = error.what();
    }
    if (!failure.empty()) {
      if (said != nullptr) *said = process_.error_output().text();
      throw CandidateError(fmt::format("{} {}{}", name, failure,
                                       limit_text(process_.error_output(), confined.limits)),
                           process_.error_output().excerpt());
    }
  }
  const fs::path& folder() const { return process_.folder(); }

 private:
  Process process_;
};

/// The compiler, without its arguments.
Confined compiler(const RunOptions& options) {
  Confined confined = options.confined();
  confined.spent = options.build_spent;
  // A rubric's limits apply to the built program, not to the compiler.
  const Limits usual;
  confined.limits.seconds = options.build_seconds;
  confined.limits.names.seconds = options.build_seconds_name;
  confined.limits.processes = std::max(options.limits.processes, kCompilerProcesses);
  confined.limits.files = kCompilerFiles;
  confined.limits.memory = std::max(options.limits.memory, usual.memory);
  confined.limits.file = std::max(options.limits.file, kCompilerFile);
  return confined;
}

}  // namespace

fs::path include_folder() {
  const fs::path installed = prefix() / "include";
  return readable_copy(fs::exists(installed / "raycheck" / "candidate.h")
                           ? installed
                           : fs::path(kSourceFolder) / "include");
}

fs::path source_folder(const fs::path& source) {
  return fs::is_directory(source) ? source : source.parent_path();
}

Compiled compile(const fs::path& source, const fs::path& to, const RunOptions& options) {
  const fs::path include = include_folder();
  Confined confined = compiler(options);
  confined.readable.push_back(include);
  confined.readable.insert(confined.readable.end(), options.includes.begin(),
                           options.includes.end());
  const bool is_folder = fs::is_directory(source);
  const fs::path folder = source_folder(source);
  confined.readable.push_back(folder);
  if (source.filename() == "CMakeLists.txt" ||
      (is_folder && fs::exists(folder / "CMakeLists.txt"))) {
    confined.arguments = {"sh",
                          "-c",
                          fmt::format("CFLAGS={0} cmake -S \"$1\" -B . -DCMAKE_BUILD_TYPE=Release "
                                      "-DCMAKE_POSITION_INDEPENDENT_CODE=ON "
                                      "\"-DCMAKE_CXX_FLAGS=-isystem $2 {0}\" >&2 && "
                                      "cmake --build . >&2",
                                      kLineTables),
                          "sh",
                          folder,
                          include};
    const BuildStep step("cmake", confined);
    const auto libraries = files_in(step.folder(), ".so");
    if (libraries.size() != 1) {
      throw CandidateError(
          fmt::format("its CMakeLists.txt builds {} shared libraries, not one", libraries.size()));
    }
    return {copied(libraries.front(), to), read_of(folder, step.folder())};
  }
  confined.arguments = {"g++",     "-std=c++20",  "-O2",      kLineTables,   "-fPIC",
                        "-shared", "-MMD",        "-isystem", include,       "-isystem",
                        kEigen,    "-Wl,-z,defs", "-o",       "candidate.so"};
  for (const fs::path& one : options.includes) {
    confined.arguments.insert(confined.arguments.end(), {"-I", one});
  }
  // No header of a source hides one of the system: "" prefers its own, <> those of the system.
  for (const fs::path& one : header_folders(folder)) {
    confined.arguments.insert(confined.arguments.end(), {"-iquote", one, "-idirafter", one});
  }
  if (is_folder) {
    const auto files = files_in(source, ".cpp");
    if (files.empty()) {
      throw CandidateError("it contains no .cpp file");
    }
    for (const fs::path& file : files) confined.arguments.push_back(file);
  } else {
    confined.arguments.push_back(source);
  }
  const BuildStep step("g++", confined);
  return {copied(step.folder() / "candidate.so", to), read_of(folder, step.folder())};
}

void build(const fs::path& folder, const BuildWords& words, const fs::path& to,
           const RunOptions& options) {
  Confined confined = compiler(options);
  confined.readable.insert(confined.readable.end(), {folder, include_folder()});
  confined.arguments = {
      "sh", "-c",   "cp -r \"$1\"/. \"$2\"/*.java . && { " + words.words + "\n} >&2",
      "sh", folder, adapters()};
  const BuildStep step(fmt::format("'{}'", words.shown), confined, words.said);
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(step.folder())) {
    if (!fs::is_regular_file(entry.symlink_status())) continue;
    if (words.keeps && !words.keeps(entry.path())) continue;
    bytes += entry.file_size();
    if (bytes > kMostBuilt) throw CandidateError(words.shown + ": its output is too large");
    copy_with_time(entry.path(), to / fs::relative(entry.path(), step.folder()));
  }
}

}  // namespace raycheck::tools
