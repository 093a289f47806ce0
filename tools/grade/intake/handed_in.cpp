#include "tools/grade/intake/handed_in.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/case_conv.hpp>
#include <cctype>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <utility>

#include "scene/invalid_input.h"
#include "tools/external/pictures/other_formats.h"
#include "tools/external/pictures/renderer.h"
#include "tools/grade/intake/sources.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Folders that archives, editors and compilers leave behind.
constexpr std::array<std::string_view, 11> kLeftFolders = {
    "__macosx", ".git",        ".svn",  ".hg",        ".vscode",           ".idea",
    ".vs",      "__pycache__", ".venv", "cmakefiles", ".ipynb_checkpoints"};
constexpr std::array<std::string_view, 4> kLeftFiles = {".ds_store", "thumbs.db", "desktop.ini",
                                                        "cmakecache.txt"};
/// Object files and precompiled headers, of any machine and compiler.
constexpr std::array<std::string_view, 6> kLeftEndings = {".o",   ".obj", ".gch",
                                                          ".pch", ".pyc", ".pdb"};

bool is_left_behind(const fs::path& path, bool is_folder) {
  const std::string name = boost::to_lower_copy(path.filename().string());
  if (is_folder) return is_one_of(kLeftFolders, name) || fs::exists(path / "pyvenv.cfg");
  return name.starts_with("._") || is_one_of(kLeftFiles, name) ||
         is_one_of(kLeftEndings, fs::path(name).extension().string());
}

/// The absolute path, with links resolved as far as the path exists.
fs::path resolved(const fs::path& path) {
  // "results/" has an empty last component.
  const fs::path whole = fs::weakly_canonical(fs::absolute(path));
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Domain: resolved paths.
bool is_in(const fs::path& path, const fs::path& folder) {
  return std::ranges::mismatch(folder, path).in1 == folder.end();
}

}  // namespace

HandedInPaths paths_of(const fs::path& path, const SubmissionLimits& limits) {
  HandedInPaths found;
  auto& [files, folders] = found;
  const auto limit = [](std::uint64_t count, std::uint64_t most, std::uint64_t unit,
                        std::string_view what) {
    if (count <= most * unit) return;
    throw std::invalid_argument(fmt::format("it has more than {} {}", most, what));
  };
  const auto limit_bytes = [&](std::uintmax_t bytes) {
    limit(bytes, limits.submission_mib, 1 << 20, "MiB (limits.submission_mib)");
  };
  const fs::file_status status = fs::symlink_status(path);
  if (fs::is_regular_file(status)) {
    limit_bytes(fs::file_size(path));
    return {{{path.filename().string(), path}}, {}};
  }
  if (!fs::is_directory(status)) throw std::invalid_argument("it is neither a file nor a folder");
  std::uintmax_t bytes = 0;
  for (fs::recursive_directory_iterator entry(path), end; entry != end; ++entry) {
    const fs::file_status own = entry->symlink_status();
    const std::string name = entry->path().lexically_relative(path).string();
    const bool is_folder = fs::is_directory(own);
    if (is_left_behind(entry->path(), is_folder)) {
      if (is_folder) entry.disable_recursion_pending();
    } else if (is_folder) {
      folders.push_back(name);
      limit(folders.size(), limits.files, 1, "folders (limits.files)");
    } else if (fs::is_regular_file(own)) {
      files.emplace(name, entry->path());
      bytes += entry->file_size();
      limit(files.size(), limits.files, 1, "files (limits.files)");
      limit_bytes(bytes);
    }
  }
  std::ranges::sort(folders);
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

std::vector<Submission> find_submissions(const std::vector<std::string>& paths,
                                         const std::vector<std::string_view>& reserved) {
  std::vector<Submission> found;
  std::map<std::string, std::string> known;
  for (const std::string& given : paths) {
    std::error_code error;
    // A link is not followed, because it may lead to another submission.
    fs::path path = fs::absolute(given).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    if (!fs::exists(fs::symlink_status(path, error))) {
      throw std::invalid_argument(fmt::format("{}: there is no such file or folder", given));
    }
    const bool is_file = fs::is_regular_file(fs::symlink_status(path));
    const std::string name = is_file ? path.stem().string() : path.filename().string();
    if (is_one_of(reserved, name)) {
      throw std::invalid_argument(
          fmt::format("{}: rename it; raycheck writes its own results under this name", given));
    }
    const auto [other, is_new] = known.try_emplace(name, given);
    if (!is_new) {
      throw std::invalid_argument(
          given == other->second
              ? fmt::format("{}: is given twice", given)
              : fmt::format("{}: {} has the same name, {}, under which results are stored; rename "
                            "one of them",
                            given, other->second, name));
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
      throw scene::InvalidInput(
          "out", out,
          fmt::format("{} {} {}, which is a submission; give another folder for the results",
                      folder.string(), where, submissions[k].path.string()));
    }
  };
  require(out);
  std::error_code ignored;
  for (const Submission& each : submissions) {
    // A folder that is not a link lies in `out`, which is checked above.
    const fs::path folder = fs::path(out) / each.name;
    if (fs::is_symlink(fs::symlink_status(folder, ignored))) require(folder);
  }
}

namespace {

/// A cell's source is a string or a list of lines.
std::string joined(const Json& source) {
  if (source.is_string()) return source.get<std::string>();
  std::string text;
  for (const Json& line : source) text += line.get<std::string>();
  return text;
}

/// Cell magics whose cell is still Python.
bool is_python_cell(const std::string& cell) {
  std::istringstream words(cell);
  std::string first;
  words >> first;
  return !first.starts_with("%%") || first == "%%time" || first == "%%timeit" ||
         first == "%%capture" || first == "%%prun";
}

/// `%matplotlib inline`, `!pip install`, `?help`; not the continuation of a formula.
bool is_magic(std::string_view line) {
  const char next = line.size() > 1 ? line[1] : ' ';
  return (line[0] == '%' && (next == '%' || std::isalpha(static_cast<unsigned char>(next)) != 0)) ||
         (line[0] == '!' && next != '=') || line[0] == '?';
}

std::string without_magics(const std::string& cell) {
  std::istringstream lines(cell);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find_first_not_of(" \t");
    const bool drops = at != std::string::npos && is_magic(std::string_view(line).substr(at));
    text += (drops ? line.substr(0, at) + "pass" : line) + "\n";
  }
  return text;
}

}  // namespace

std::optional<std::string> notebook_module(std::string_view text) try {
  const Json notebook = Json::parse(text);
  std::string module;
  for (const Json& cell : notebook.at("cells")) {
    if (cell.at("cell_type") != "code") continue;
    const std::string code = joined(cell.at("source"));
    if (is_python_cell(code)) module += without_magics(code) + "\n";
  }
  return module;
} catch (const Json::exception&) {
  return {};
}

namespace {

/// The endings of pictures that are not read.
constexpr std::array<std::string_view, 3> kPictureEndings = {".pgm", ".pbm", ".gif"};

/// A run's folder contains at most this many folders and files of a submission; those nearer to the
/// top come first.
constexpr std::size_t kMostInRunFolder = 100;
/// Files of at most the first size are copied there, as long as all copies fit into the second
/// size; others are linked.
constexpr std::size_t kMostOfCopy = std::size_t{64} << 10;
constexpr std::size_t kMostOfCopies = std::size_t{1} << 20;

/// Whether a run needs this name for its own files.
bool is_taken(const std::string& path) {
  const std::string top = path.substr(0, path.find('/'));
  return is_scene_file(top) || top == kImageFile;
}

/// The order of paths: nearer to the top first, so that a folder comes before its contents.
std::tuple<std::ptrdiff_t, std::string> nearness(const std::string& path) {
  return {std::ranges::count(path, '/'), path};
}

/// Files that are not pictures, programs or archives are listed from this size on.
constexpr std::uintmax_t kLargeFile = std::uintmax_t{256} << 10;
/// Lines that are longer are not written by hand.
constexpr std::size_t kLongLine = 4000;

struct Beginning {
  std::string_view bytes;
  std::string_view kind;
};
constexpr std::string_view kPicture = "picture";
constexpr Beginning kBeginnings[] = {{"\x7f"
                                      "ELF",
                                      "program or library"},
                                     {"MZ", "Windows program"},
                                     {"\xcf\xfa\xed\xfe", "macOS program"},
                                     {"\xca\xfe\xba\xbe", "Java class"},
                                     {"!<arch>\n", "static library"},
                                     {"PK\x03\x04", "archive"},
                                     {"\x1f\x8b", "compressed"},
                                     {"\xfd"
                                      "7zXZ",
                                      "compressed"},
                                     {"\x89PNG", kPicture},
                                     {"\xff\xd8\xff", kPicture},
                                     {"GIF8", kPicture},
                                     {"BM", kPicture},
                                     {"\x76\x2f\x31\x01", kPicture}};

/// The beginnings of PNG and of PPM in Base64.
constexpr std::string_view kEmbedded[] = {"iVBORw0KGgo", "UDYK", "UDMK"};

/// PPM and its kin: P1 to P6, then white space.
bool is_portable_picture(std::string_view text) {
  return text.size() > 2 && text[0] == 'P' && text[1] >= '1' && text[1] <= '6' &&
         std::isspace(static_cast<unsigned char>(text[2])) != 0;
}

bool has_long_line(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end - at > kLongLine) return true;
    at = end + 1;
  }
  return false;
}

/// The kind of a file by its beginning; empty for others.
std::string_view kind_by_beginning(std::string_view text) {
  for (const Beginning& one : kBeginnings) {
    if (text.starts_with(one.bytes)) return one.kind;
  }
  return is_portable_picture(text) ? kPicture : "";
}

/// The kind of an opaque file; empty for others.
std::string_view kind_of(std::string_view text, std::uintmax_t bytes) {
  const std::string_view kind = kind_by_beginning(text);
  if (!kind.empty()) return kind;
  const bool has_picture = std::ranges::any_of(kEmbedded, [&](std::string_view begin) {
    return text.find(begin) != std::string_view::npos;
  });
  if (has_picture) return "text with a picture in it";
  if (has_long_line(text)) return "text with very long lines";
  return bytes >= kLargeFile ? "large file" : "";
}

}  // namespace

std::shared_ptr<const StartingFolder> run_folder(const HandedInFiles& files,
                                                 const std::vector<std::string>& folders,
                                                 std::shared_ptr<const PrivateFolder> copy) {
  const Vendored vendored = vendored_in(files);
  const auto is_left_out = [&](const std::string& path) {
    return is_taken(path) || vendored.has(path + "/");
  };
  StartingFolder start;
  std::vector<std::string> names;
  for (const std::string& folder : folders) {
    if (!is_left_out(folder)) start.folders.push_back(folder);
  }
  for (const auto& [name, file] : files) {
    if (is_left_out(name) || is_picture_name(name) || is_one_of(kPictureEndings, ending_of(name)) ||
        kind_by_beginning(file.text) == kPicture)
      continue;
    names.push_back(name);
  }
  std::ranges::sort(start.folders, {}, nearness);
  start.folders.resize(std::min(start.folders.size(), kMostInRunFolder));
  std::ranges::sort(names, {}, nearness);
  const std::set<std::string> made(start.folders.begin(), start.folders.end());
  std::size_t copied = 0;
  for (const std::string& name : names) {
    const std::size_t count = start.folders.size() + start.files.size() + start.links.size();
    if (count >= kMostInRunFolder) break;
    if (!folder_of(name).empty() && !made.contains(folder_of(name))) continue;
    const HandedInFile& file = files.at(name);
    if (file.text.size() <= kMostOfCopy && copied + file.text.size() <= kMostOfCopies) {
      copied += file.text.size();
      start.files.push_back({name, file.text, file.runs});
    } else {
      start.links.push_back(name);
    }
  }
  start.linked = std::move(copy);
  return std::make_shared<const StartingFolder>(std::move(start));
}

std::vector<OpaqueFile> opaque_files(const HandedInFiles& files,
                                     const std::map<std::string, fs::path>& paths) {
  std::vector<OpaqueFile> found;
  for (const auto& [name, path] : paths) {
    const std::uintmax_t bytes = fs::file_size(path);
    const std::string_view kind = kind_of(files.at(name).text, bytes);
    if (!kind.empty()) found.push_back({name, std::string(kind), bytes});
  }
  return found;
}

}  // namespace raycheck::tools
