#include "tools/grade/intake/handed_in.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

#include "tools/external/sandbox/file_tree.h"
#include "tools/grade/intake/sources.h"
#include "tools/grade/rubric/rubric_files.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReadOfFile = std::size_t{4} << 20;

/// Folders that archives, editors and compilers leave behind.
constexpr std::array<std::string_view, 11> kLeftFolders = {
    "__macosx", ".git",        ".svn",  ".hg",        ".vscode",           ".idea",
    ".vs",      "__pycache__", ".venv", "cmakefiles", ".ipynb_checkpoints"};
constexpr std::array<std::string_view, 4> kLeftFiles = {".ds_store", "thumbs.db", "desktop.ini",
                                                        "cmakecache.txt"};
/// Object files and precompiled headers, of any machine and compiler.
constexpr std::array<std::string_view, 6> kLeftEndings = {".o",   ".obj", ".gch",
                                                          ".pch", ".pyc", ".pdb"};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_left_behind(const fs::path& path, bool is_folder) {
  const std::string name = lower_case(path.filename().string());
  if (is_folder) return is_among(kLeftFolders, name) || fs::exists(path / "pyvenv.cfg");
  return name.starts_with("._") || is_among(kLeftFiles, name) ||
         is_among(kLeftEndings, fs::path(name).extension().string());
}

/// Absolute, with links resolved as far as the path exists.
fs::path resolved(const fs::path& path) {
  // "results/" has an empty last component.
  const fs::path whole = fs::weakly_canonical(fs::absolute(path));
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Domain: both resolved.
bool is_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

}  // namespace

HandedInPaths paths_of(const fs::path& path, const SubmissionLimits& limits) {
  const std::uintmax_t most = limits.submission_mib << 20;
  HandedInPaths found;
  auto& [files, folders] = found;
  const fs::file_status status = fs::symlink_status(path);
  if (fs::is_regular_file(status) && fs::file_size(path) <= most) {
    return {{{path.filename().string(), path}}, {}};
  }
  if (!fs::is_directory(status)) {
    throw std::invalid_argument(
        fs::is_regular_file(status)
            ? fmt::format("it has more than {} MiB (submission_mib)", limits.submission_mib)
            : "it is neither a file nor a folder");
  }
  std::uintmax_t bytes = 0;
  for (fs::recursive_directory_iterator entry(path), end; entry != end; ++entry) {
    const fs::file_status own = entry->symlink_status();
    if (fs::is_directory(own)) {
      if (is_left_behind(entry->path(), true)) {
        entry.disable_recursion_pending();
      } else if (folders.push_back(entry->path().lexically_relative(path).string());
                 folders.size() > limits.files) {
        throw std::invalid_argument(
            fmt::format("it has more than {} folders (files)", limits.files));
      }
    }
    if (!fs::is_regular_file(own) || is_left_behind(entry->path(), false)) continue;
    files.emplace(entry->path().lexically_relative(path).string(), entry->path());
    bytes += entry->file_size();
    if (files.size() > limits.files) {
      throw std::invalid_argument(fmt::format("it has more than {} files (files)", limits.files));
    }
    if (bytes > most) {
      throw std::invalid_argument(
          fmt::format("it has more than {} MiB (submission_mib)", limits.submission_mib));
    }
  }
  std::sort(folders.begin(), folders.end());
  return found;
}

fs::path innermost(fs::path path, const std::function<bool(const std::string&)>& is_meant) {
  while (fs::is_directory(fs::symlink_status(path))) {
    std::vector<fs::directory_entry> entries;
    for (const auto& entry : fs::directory_iterator(path)) {
      const bool is_folder = fs::is_directory(entry.symlink_status());
      const bool is_hidden = entry.path().filename().string().starts_with('.');
      if (!is_hidden && !is_left_behind(entry.path(), is_folder)) entries.push_back(entry);
    }
    if (entries.size() != 1 || !fs::is_directory(entries[0].symlink_status()) ||
        is_meant(entries[0].path().filename().string())) {
      break;
    }
    path = entries[0].path();
  }
  return path;
}

std::string digest_of(const HandedInPaths& paths) {
  std::vector<std::string> texts = paths.folders;
  for (const auto& [name, path] : paths.files) {
    texts.push_back(name);
    const bool runs = (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
    texts.emplace_back(runs ? "runs" : "");
    texts.push_back(file_bytes(path));
  }
  return digest(texts);
}

HandedInFiles read_files(const std::map<std::string, fs::path>& paths) {
  HandedInFiles files;
  for (const auto& [name, path] : paths) {
    HandedInFile& file = files[name];
    file.text = file_bytes(path, kReadOfFile);
    file.runs = (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
  }
  return files;
}

std::vector<Submission> find_submissions(const std::vector<std::string>& paths,
                                         const std::vector<std::string_view>& reserved) {
  std::vector<Submission> found;
  std::map<std::string, std::string> known;
  for (const std::string& given : paths) {
    std::error_code error;
    // A link is not followed: it may lead to another's submission.
    fs::path path = fs::absolute(given).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    if (!fs::exists(fs::symlink_status(path, error))) {
      throw std::invalid_argument(fmt::format("{}: there is no such file or folder", given));
    }
    const bool is_file = fs::is_regular_file(fs::symlink_status(path));
    const std::string name = is_file ? path.stem().string() : path.filename().string();
    if (std::find(reserved.begin(), reserved.end(), name) != reserved.end()) {
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

void require_disjoint(const std::string& out, const std::vector<Submission>& submissions) {
  std::vector<fs::path> handed_in;
  for (const Submission& each : submissions) handed_in.push_back(resolved(each.path));
  const auto require = [&](const fs::path& folder) {
    const fs::path results = resolved(folder);
    for (std::size_t k = 0; k < handed_in.size(); ++k) {
      const char* where = results == handed_in[k]        ? "is"
                          : is_in(handed_in[k], results) ? "holds"
                          : is_in(results, handed_in[k]) ? "lies in"
                                                         : nullptr;
      if (where == nullptr) continue;
      throw std::invalid_argument(
          fmt::format("out {}: {} {} {}, which is handed in; results take another folder", out,
                      folder.string(), where, submissions[k].path.string()));
    }
  };
  require(out);
  std::error_code ignored;
  for (const Submission& each : submissions) {
    // Others lie in `out` as it was looked at.
    const fs::path folder = fs::path(out) / each.name;
    if (fs::is_symlink(fs::symlink_status(folder, ignored))) require(folder);
  }
}

}  // namespace raycheck::tools
