#include "tools/candidates/find.h"

#include <fmt/core.h>

#include <CLI/StringTools.hpp>
#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "tools/candidates/compile.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kWays =
    "library:PATH.so, source:PATH, command:'WORDS' or "
    "renderer:'WORDS with {scene} and {image}'";

fs::path existing(const std::string& what, const std::string& path) {
  std::error_code error;
  fs::path found = fs::canonical(path, error);
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
  fs::permissions(folder->path(), fs::perms::owner_all | fs::perms::group_exec |
                                      fs::perms::group_read | fs::perms::others_exec |
                                      fs::perms::others_read);
  fs::permissions(copy, fs::perms::group_read | fs::perms::others_read, fs::perm_options::add);
  const std::string worker = program_folder() / "raycheck-worker";
  const Confined program{
      {worker, copy.string()}, {worker, folder->path()}, options.layers, options.limits};
  return introduced(what, program, std::move(folder));
}

/// A program by its words, those that name files made absolute.
Confined program_of(const std::string& what, const std::string& words, const RunOptions& options) {
  Confined program;
  program.limits = options.limits;
  for (const std::string& word : CLI::detail::split_up(words)) {
    std::error_code error;
    const fs::path path = fs::canonical(word, error);
    // A word of dots alone is more likely an argument than a folder.
    if (error || word.find_first_not_of('.') == std::string::npos) {
      program.arguments.push_back(word);
      continue;
    }
    program.arguments.push_back(path);
    program.readable.push_back(fs::is_directory(path) ? path : path.parent_path());
  }
  if (program.arguments.empty()) {
    throw std::invalid_argument(fmt::format("--candidate {}: it names no program", what));
  }
  program.layers = layers_for(options.layers, program.readable);
  return program;
}

External renderer(const std::string& what, const std::string& words, const RunOptions& options) {
  for (const char* mark : {"{scene}", "{image}"}) {
    if (words.find(mark) == std::string::npos) {
      throw std::invalid_argument(fmt::format("--candidate {}: {} is missing", what, mark));
    }
  }
  return rendering(what, {program_of(what, words, options), options.dialect,
                          options.excused_image_change, options.image_threshold});
}

}  // namespace

External find_external(const std::string& what, const RunOptions& options) {
  const std::size_t colon = what.find(':');
  const std::string way = what.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : what.substr(colon + 1);
  if (rest.empty()) {
    throw std::invalid_argument(fmt::format("--candidate {}: give {}", what, kWays));
  }
  if (way == "library") return library(what, existing(what, rest), options);
  if (way == "source") {
    const PrivateFolder built;
    return library(what, compile(what, existing(what, rest), built.path(), options), options);
  }
  if (way == "command") return introduced(what, program_of(what, rest, options));
  if (way == "renderer") return renderer(what, rest, options);
  throw std::invalid_argument(
      fmt::format("--candidate {}: there is no {}:; give {}", what, way, kWays));
}

}  // namespace raycheck::tools
