#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::scene {

/// How the statements of a text contain others: not, by indentation (YAML) or by tags (XML).
enum class Nesting { kNone, kIndentation, kTags };
inline constexpr std::array<std::string_view, 3> kNestingNames = {"none", "indentation", "tags"};

/// The words of a value, after the names of what contains it in its block: "film width 640".
struct NestedRow {
  std::vector<std::string> words;
  std::size_t line = 1;
  bool begins = false;  ///< Whether it is the first of a block: an outermost item or element.
};

/// The rows of a text, by libyaml or expat. The items of YAML's outermost sequence are blocks. In a
/// block of tags an element with a name goes by it, its value and its x, y and z follow the name,
/// and so does each other attribute.
/// Errors: SceneFileError with the line if the text is not valid YAML or XML, has an alias, or is
/// nested too deeply.
std::vector<NestedRow> nested_rows(Nesting nesting, std::string_view text,
                                   std::string_view separators, std::string_view file);

/// The words of a text.
std::vector<std::string_view> split_words(std::string_view text, std::string_view separators);

}  // namespace raycheck::scene
