#include "tools/external/locate.h"

#include <fmt/core.h>

#include <algorithm>
#include <boost/tokenizer.hpp>
#include <map>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "tools/external/compile.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kWays =
    "library:PATH.so, source:PATH, command:'WORDS' or "
    "renderer:'WORDS with {scene} and {image}'";

fs::path existing(const std::string& what, const std::string& path, const RunOptions& options) {
  std::error_code error;
  fs::path found = fs::canonical(options.folder / path, error);
  if (error) {
    throw std::invalid_argument(fmt::format("--candidate {}: {}: {}", what, path, error.message()));
  }
  return found;
}

/// The library in a folder that whoever the candidate runs as may read.
External library(const std::string& what, const fs::path& path, const RunOptions& options) {
  auto folder = std::make_shared<PrivateFolder>();
  const fs::path copy = folder->path() / path.filename();
  fs::copy_file(path, copy);
  open_to_others(folder->path());
  const std::string worker = helper("raycheck-worker");
  const Confined program{
      {worker, copy.string()}, {worker, folder->path()}, options.layers, options.limits};
  return introduced(what, program, std::move(folder));
}

/// What is copied at most of a folder that is closed to others.
constexpr std::uintmax_t kMostCopied = std::uintmax_t{64} << 20;

/// Copies a folder for a user that may not read it.
void copy_opened(const std::string& what, const fs::path& from, const fs::path& to) {
  std::uintmax_t copied = 0;
  if (!fs::relative(to, from).string().starts_with("..")) {
    throw std::invalid_argument(
        fmt::format("--candidate {}: {} is closed to other users; give the program a folder of its "
                    "own",
                    what, from.string()));
  }
  for (const auto& entry : fs::recursive_directory_iterator(from)) {
    const fs::path target = to / fs::relative(entry.path(), from);
    const fs::file_status status = entry.symlink_status();
    if (fs::is_directory(status)) fs::create_directories(target);
    // What is closed itself is not the candidate's to read, unless it is named.
    if (!fs::is_regular_file(status) ||
        (status.permissions() & fs::perms::others_read) == fs::perms::none) {
      continue;
    }
    copied += entry.file_size();
    if (copied > kMostCopied) {
      throw std::invalid_argument(fmt::format(
          "--candidate {}: {} is closed to other users and too large to be copied; give "
          "the program a folder of its own, or --sandbox none",
          what, from.string()));
    }
    fs::copy_file(entry.path(), target);
  }
  open_to_others(to);
}

/// Paths as the user that a candidate runs as may read them: folders that are closed to others are
/// copied, once each.
class Opened {
 public:
  Opened(std::string what, const Layers& layers)
      : what_(std::move(what)), other_user_(layers.other_user) {}

  /// The path of a file or folder, or of its copy.
  fs::path operator()(const fs::path& path) {
    const fs::path folder = folder_of(path);
    if (!other_user_ || others_may_read(folder)) return path;
    if (!copies_) {
      copies_ = std::make_shared<PrivateFolder>();
      open_to_others(copies_->path());
    }
    const auto [copy, is_new] =
        known_.try_emplace(folder, copies_->path() / std::to_string(known_.size()));
    if (is_new) {
      fs::create_directory(copy->second);
      copy_opened(what_, folder, copy->second);
    }
    if (folder == path) return copy->second;
    const fs::path file = copy->second / path.filename();
    if (!fs::exists(file)) {
      fs::copy_file(path, file);
      open_to_others(file);
    }
    return file;
  }
  static fs::path folder_of(const fs::path& path) {
    return fs::is_directory(path) ? path : path.parent_path();
  }
  /// What the copies lie in; null: there are none.
  std::shared_ptr<const PrivateFolder> copies() const { return copies_; }

 private:
  std::string what_;
  bool other_user_;
  std::shared_ptr<PrivateFolder> copies_;
  std::map<fs::path, fs::path> known_;
};

/// Words as a shell splits them: quotes of either kind keep spaces inside a word.
std::vector<std::string> split(const std::string& text) {
  const boost::escaped_list_separator<char> separator("", " \t\n", "\"'");
  std::vector<std::string> words;
  for (const std::string& word : boost::tokenizer(text, separator)) {
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

/// A program by its words. Those that name files are made absolute.
Confined program_of(const std::string& what, const std::string& words, const RunOptions& options,
                    Opened& opened) {
  Confined program;
  program.layers = options.layers;
  program.limits = options.limits;
  for (const std::string& word : split(words)) {
    // A bare first word is a program on the path. Links stay: programs look at their own names.
    const bool is_program = program.arguments.empty() && word.find('/') == std::string::npos;
    std::error_code error;
    const fs::path named = options.folder / word;
    if (is_program || !fs::exists(named, error)) {
      program.arguments.push_back(word);
      continue;
    }
    const fs::path path = opened(fs::absolute(named).lexically_normal());
    const fs::path folder = Opened::folder_of(path);
    const bool is_everyones = folder == "/" || folder == fs::temp_directory_path();
    program.arguments.push_back(path);
    if (!is_everyones) {
      program.readable.push_back(folder);
    } else if (folder != path) {
      program.readable.push_back(path);
    }
  }
  if (program.arguments.empty()) {
    throw std::invalid_argument(fmt::format("--candidate {}: it names no program", what));
  }
  return program;
}

External renderer(const std::string& what, const std::string& words, const RunOptions& options) {
  for (const char* mark : {"{scene}", "{image}"}) {
    if (words.find(mark) == std::string::npos) {
      throw std::invalid_argument(fmt::format("--candidate {}: {} is missing", what, mark));
    }
  }
  Opened opened(what, options.layers);
  const Confined program = program_of(what, words, options, opened);
  External external = rendering(
      what, {program, options.dialect, options.excused_image_change, options.image_threshold});
  external.folder = opened.copies();
  return external;
}

}  // namespace

External find_external(const std::string& what, const RunOptions& options) {
  const std::size_t colon = what.find(':');
  const std::string way = what.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : what.substr(colon + 1);
  if (rest.empty()) {
    throw std::invalid_argument(fmt::format("--candidate {}: give {}", what, kWays));
  }
  Opened opened(what, options.layers);
  if (way == "library") return library(what, existing(what, rest, options), options);
  if (way == "source") {
    const PrivateFolder built;
    return library(
        what, compile(what, opened(existing(what, rest, options)), built.path(), options), options);
  }
  if (way == "command") {
    const Confined program = program_of(what, rest, options, opened);
    return introduced(what, program, opened.copies());
  }
  if (way == "renderer") return renderer(what, rest, options);
  throw std::invalid_argument(
      fmt::format("--candidate {}: there is no {}:; give {}", what, way, kWays));
}

}  // namespace raycheck::tools
