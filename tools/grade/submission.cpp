#include "tools/grade/submission.h"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "tools/external/compile.h"
#include "tools/grade/digest.h"
#include "tools/grade/views.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;
constexpr std::size_t kMostFiles = 10000;

[[noreturn]] void refuse(const std::string& why) { throw SubmissionError({why, ""}, {}); }

/// The regular files of a submission, by their paths in it, in order. Links are not followed: they
/// may lead to what is not the submission's.
std::map<std::string, fs::path> files_of(const fs::path& path) {
  std::map<std::string, fs::path> files;
  const fs::file_status status = fs::symlink_status(path);
  if (fs::is_regular_file(status) && fs::file_size(path) <= kMostBytes) {
    return {{path.filename().string(), path}};
  }
  if (!fs::is_directory(status)) {
    refuse(fs::is_regular_file(status) ? fmt::format("it has more than {} MiB", kMostBytes >> 20)
                                       : "it is neither a file nor a folder");
  }
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path)) {
    if (!fs::is_regular_file(entry.symlink_status())) continue;
    files.emplace(fs::relative(entry.path(), path).string(), entry.path());
    bytes += entry.file_size();
    if (files.size() > kMostFiles || bytes > kMostBytes) {
      refuse(fmt::format("it has more than {} files or {} MiB", kMostFiles, kMostBytes >> 20));
    }
  }
  return files;
}

/// Where a folder has nothing but another, as unpacked archives do, that; what is hidden aside.
fs::path innermost(fs::path path) {
  while (fs::is_directory(fs::symlink_status(path))) {
    std::vector<fs::directory_entry> entries;
    for (const auto& entry : fs::directory_iterator(path)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with('.') && name != "__MACOSX") entries.push_back(entry);
    }
    if (entries.size() != 1 || !fs::is_directory(entries[0].symlink_status())) break;
    path = entries[0].path();
  }
  return path;
}

/// A file's name as one word of a shell.
std::string shell_word(const std::string& name) {
  std::string word = "'";
  for (const char c : name) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// A file's name as one of a candidate's words, which are split where no quotes are.
std::string candidate_word(const std::string& name) {
  const char quote = name.find('"') == std::string::npos ? '"' : '\'';
  return name.find_first_of(" \t\"'") == std::string::npos ? name : quote + name + quote;
}

std::string with_file(std::string text, const std::string& word) {
  constexpr std::string_view kMark = "{file}";
  for (std::size_t at = 0; (at = text.find(kMark, at)) != std::string::npos; at += word.size()) {
    text.replace(at, kMark.size(), word);
  }
  return text;
}

/// The form that fits, and the file that says so.
std::pair<const Form*, std::string> form_of(const fs::path& folder, const Rubric& rubric) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  for (const Form& form : rubric.forms) {
    for (const std::string& name : names) {
      if (fnmatch(form.has.c_str(), name.c_str(), 0) == 0) return {&form, name};
    }
  }
  std::string asked;
  for (const Form& form : rubric.forms) asked += (asked.empty() ? "" : ", ") + form.has;
  refuse(asked.empty() ? "the rubric has no [[form]] of submissions"
                       : fmt::format("it has none of the files that are asked for: {}", asked));
}

}  // namespace

std::vector<Submission> find_submissions(const std::vector<std::string>& paths) {
  std::vector<Submission> found;
  std::map<std::string, std::string> known;
  for (const std::string& given : paths) {
    std::error_code error;
    // A link is not followed: it may lead to someone else's.
    fs::path path = fs::absolute(given).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    if (!fs::exists(fs::symlink_status(path, error))) {
      throw std::invalid_argument(fmt::format("{}: there is no such file or folder", given));
    }
    const bool is_file = fs::is_regular_file(fs::symlink_status(path));
    const std::string name = is_file ? path.stem().string() : path.filename().string();
    const auto files = class_files();
    if (std::any_of(files.begin(), files.end(),
                    [&](const ClassView& file) { return file.name == name; })) {
      throw std::invalid_argument(
          fmt::format("{}: rename it; the results of the class are called so", given));
    }
    const auto [other, is_new] = known.try_emplace(name, given);
    if (!is_new) {
      throw std::invalid_argument(
          fmt::format("{}: {} has the same name, {}", given, other->second, name));
    }
    found.push_back({name, path});
  }
  return found;
}

std::string digest(const Submission& submission) {
  std::vector<std::string> texts;
  try {
    for (const auto& [name, path] : files_of(submission.path)) {
      std::ifstream file(path, std::ios::binary);
      texts.push_back(name);
      const bool runs = (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
      texts.emplace_back(runs ? "runs" : "");
      texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
  } catch (const std::exception& error) {
    texts = {error.what()};
  }
  return digest(texts);
}

RunnableSubmission prepare(const Submission& submission, const Rubric& rubric,
                           const Layers& layers) try {
  auto folder = std::make_shared<PrivateFolder>();
  for (const auto& [name, path] : files_of(innermost(submission.path))) {
    const fs::path to = folder->path() / name;
    fs::create_directories(to.parent_path());
    fs::copy_file(path, to);
  }
  const auto [form, file] = form_of(folder->path(), rubric);
  CandidateSpec program = form->program;
  program.what = with_file(program.what, program.is_words() ? candidate_word(file) : file);
  RunOptions options;
  options.layers = layers;
  options.limits.seconds = rubric.reply_seconds;
  options.build_seconds = rubric.build_seconds;
  options.dialect = rubric.dialect;
  options.bounds = rubric.bounds;
  options.excused_image_change = rubric.image_change;
  options.image_threshold = rubric.t_threshold;
  open_to_others(folder->path());
  try {
    if (!form->build.empty()) {
      auto built = std::make_shared<PrivateFolder>();
      build(folder->path(), with_file(form->build, shell_word(file)), built->path(), options);
      folder = std::move(built);
      open_to_others(folder->path());
    }
    options.folder = folder->path();
    RunnableSubmission runnable{find_external(program, options), program};
    // The program's folder lasts as long as it; a library has one of its own.
    if (!runnable.external.folder) runnable.external.folder = std::move(folder);
    return runnable;
  } catch (const CandidateError& error) {
    throw SubmissionError({error.why(), error.said()}, program);
  }
} catch (const fs::filesystem_error& error) {
  refuse("its files: " + error.code().message());
}

}  // namespace raycheck::tools
