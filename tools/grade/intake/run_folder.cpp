// Where a renderer runs, and which files nobody sees through by reading them.

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "tools/external/pictures/renderer.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/intake/sources.h"

namespace raycheck::tools {
namespace {

constexpr std::array<std::string_view, 9> kPictureEndings = {
    ".ppm", ".pnm", ".pgm", ".pbm", ".png", ".jpg", ".jpeg", ".gif", ".bmp"};

bool is_called_a_picture(const std::string& path) {
  return std::find(kPictureEndings.begin(), kPictureEndings.end(), ending_of(path)) !=
         kPictureEndings.end();
}

/// Whether a run uses that name for another file.
bool is_taken(const std::string& path) {
  const std::string top = path.substr(0, path.find('/'));
  return top == kSceneFile || top == kImageFile;
}

/// Nearer to the top first, so that a folder comes before what lies in it.
bool is_nearer(const std::string& a, const std::string& b) {
  const auto key = [](const std::string& path) {
    return std::tuple<std::ptrdiff_t, const std::string&>(std::count(path.begin(), path.end(), '/'),
                                                          path);
  };
  return key(a) < key(b);
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
    if (is_left_out(name) || is_called_a_picture(name) || is_picture(file.text)) continue;
    names.push_back(name);
  }
  std::sort(start.folders.begin(), start.folders.end(), is_nearer);
  start.folders.resize(std::min(start.folders.size(), kMostInRunFolder));
  std::sort(names.begin(), names.end(), is_nearer);
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

namespace {

namespace fs = std::filesystem;

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
                                     {"BM", kPicture}};

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

/// Empty for files that are not opaque.
std::string kind_of(std::string_view text, std::uintmax_t bytes) {
  for (const Beginning& one : kBeginnings) {
    if (text.starts_with(one.bytes)) return std::string(one.kind);
  }
  if (is_portable_picture(text)) return std::string(kPicture);
  const bool has_picture = std::any_of(
      std::begin(kEmbedded), std::end(kEmbedded),
      [&](std::string_view begin) { return text.find(begin) != std::string_view::npos; });
  if (has_picture) return "text with a picture in it";
  if (has_long_line(text)) return "text with very long lines";
  return bytes >= kLargeFile ? "large file" : "";
}

}  // namespace

bool is_picture(std::string_view text) {
  return is_portable_picture(text) ||
         std::any_of(std::begin(kBeginnings), std::end(kBeginnings), [&](const Beginning& one) {
           return one.kind == kPicture && text.starts_with(one.bytes);
         });
}

std::vector<OpaqueFile> opaque_files(const HandedInFiles& files,
                                     const std::map<std::string, fs::path>& paths) {
  std::vector<OpaqueFile> found;
  for (const auto& [name, path] : paths) {
    const std::uintmax_t bytes = fs::file_size(path);
    const std::string kind = kind_of(files.at(name).text, bytes);
    if (!kind.empty()) found.push_back({name, kind, bytes});
  }
  return found;
}

}  // namespace raycheck::tools
