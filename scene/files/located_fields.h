#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace raycheck::scene {

/// Throws the errors of a file. They have the form `FILE:LINE: FIELD = VALUE: what is wrong`; lines
/// count from 1. Control characters are escaped (scene/text.h) and long values truncated, so that
/// each error fits on one line.
class LocatedFields {
 public:
  explicit LocatedFields(std::string_view file) : file_(file) {}

  /// Throws SceneFileError.
  [[noreturn]] void fail(std::size_t line, std::string_view field, std::string_view value,
                         std::string_view what) const;
  /// Throws SceneFileError about a field that has no value.
  [[noreturn]] void fail(std::size_t line, std::string_view field, std::string_view what) const;

  /// The line that sets a field, named as in scene/validate.h; empty if the field is not set.
  using LineOf = std::function<std::optional<std::size_t>(const std::string& field)>;
  /// Throws SceneFileError listing the first problems of the scene, one per line, if there are any.
  void require_valid(const Scene& scene, const LineOf& line_of) const;

  /// "FILE:LINE: FIELD: what"
  std::string located(std::size_t line, std::string_view field, std::string_view what) const;

 private:
  std::string file_;
};

/// Reads all of `text` as a whole number in decimal digits with an optional sign.
std::optional<std::int64_t> parse_integer(std::string_view text);

}  // namespace raycheck::scene
