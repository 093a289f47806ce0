#include "scene/files/located_fields.h"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <vector>

#include "scene/files/scene_file.h"
#include "scene/text.h"
#include "scene/validate.h"

namespace raycheck::scene {
namespace {

constexpr std::size_t kMaxShown = 120;
constexpr std::size_t kMostListed = 20;  ///< The largest number of problems listed for a scene.

std::string on_one_line(std::string_view text) {
  if (text.size() <= kMaxShown) return visible_line(text);
  std::size_t end = kMaxShown;
  // Do not cut within a character.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return visible_line(text.substr(0, end)) + "...";
}

}  // namespace

std::string LocatedFields::located(std::size_t line, std::string_view field,
                                   std::string_view what) const {
  return visible_line(file_) + ":" + std::to_string(line) + ": " + on_one_line(field) + ": " +
         std::string(what);
}

void LocatedFields::fail(std::size_t line, std::string_view field, std::string_view value,
                         std::string_view what) const {
  throw SceneFileError(visible_line(file_) + ":" + std::to_string(line) + ": " +
                       on_one_line(field) + " = " + on_one_line(value) + ": " + std::string(what));
}

void LocatedFields::fail(std::size_t line, std::string_view field, std::string_view what) const {
  throw SceneFileError(located(line, field, what));
}

void LocatedFields::require_valid(const Scene& scene, const LineOf& line_of) const {
  const std::vector<Defect> found = defects(scene);
  if (found.empty()) return;
  std::string message;
  for (std::size_t k = 0; k < std::min(found.size(), kMostListed); ++k) {
    const auto& [field, value, what] = found[k];
    if (k > 0) message += '\n';
    message += located(line_of(field).value_or(1), field + " = " + value, what);
  }
  if (found.size() > kMostListed) {
    message += "\nand " + std::to_string(found.size() - kMostListed) + " more problems";
  }
  throw SceneFileError(message);
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace raycheck::scene
