#ifndef RAYCHECK_SCENE_FILES_LOCATED_FIELDS_H_
#define RAYCHECK_SCENE_FILES_LOCATED_FIELDS_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace raycheck::scene {

/// Where in a file each field was given, so that every error can name its line. Lines count from 1.
/// Errors have the form `FILE:LINE: FIELD = VALUE: what is wrong`, with control characters replaced
/// and long values cut, so that each stays on one line.
class LocatedFields {
 public:
  explicit LocatedFields(std::string_view file) : file_(file) {}

  /// Notes that `field`, as scene/validate.h spells it, was given on `line`.
  void put(const std::string& field, std::size_t line) { lines_[field] = line; }

  /// Throws SceneFileError.
  [[noreturn]] void fail(std::size_t line, std::string_view field, std::string_view value,
                         std::string_view what) const;
  /// Throws SceneFileError about something that has no value.
  [[noreturn]] void fail(std::size_t line, std::string_view field, std::string_view what) const;

  /// Throws SceneFileError listing every problem of the scene, one a line, unless there is none.
  void require_valid(const Scene& scene) const;

  /// "FILE:LINE: text".
  std::string located(std::size_t line, std::string_view text) const;

 private:
  std::string file_;
  std::map<std::string, std::size_t> lines_;
};

/// Reads all of `text` as a whole number in decimal digits with an optional sign.
std::optional<std::int64_t> parse_integer(std::string_view text);

}  // namespace raycheck::scene

#endif  // RAYCHECK_SCENE_FILES_LOCATED_FIELDS_H_
