// What nobody sees through by reading a submission.

#include <algorithm>
#include <cctype>
#include <string_view>

#include "tools/grade/intake/handed_in.h"

namespace raycheck::tools {
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

/// Empty where there is nothing to say of it.
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
