#include "scene/files/located_fields.h"

#include <charconv>
#include <system_error>

#include "scene/files/scene_file.h"
#include "scene/validate.h"

namespace raycheck::scene {
namespace {

constexpr std::size_t kMaxShown = 120;

std::string on_one_line(std::string_view text) {
  std::string shown(text.substr(0, kMaxShown));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  if (text.size() > kMaxShown) shown += "...";
  return shown;
}

}  // namespace

std::string LocatedFields::located(std::size_t line, std::string_view text) const {
  return file_ + ":" + std::to_string(line) + ": " + std::string(text);
}

void LocatedFields::fail(std::size_t line, std::string_view field, std::string_view value,
                         std::string_view what) const {
  throw SceneFileError(
      located(line, on_one_line(field) + " = " + on_one_line(value) + ": " + std::string(what)));
}

void LocatedFields::fail(std::size_t line, std::string_view field, std::string_view what) const {
  throw SceneFileError(located(line, on_one_line(field) + ": " + std::string(what)));
}

void LocatedFields::require_valid(const Scene& scene) const {
  std::string message;
  for (const Defect& defect : defects(scene)) {
    const auto known = lines_.find(defect.field);
    if (!message.empty()) message += '\n';
    message += located(known == lines_.end() ? 1 : known->second,
                       defect.field + " = " + defect.value + ": " + defect.what);
  }
  if (!message.empty()) throw SceneFileError(message);
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  std::int64_t value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc{} || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace raycheck::scene
