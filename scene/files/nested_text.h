#pragma once

// Texts whose statements contain each other, by indentation (YAML) or tags (XML), as rows.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::scene {

/// How statements contain others.
enum class Nesting { kNone, kIndentation, kTags };
inline constexpr std::array<std::string_view, 3> kNestingNames = {"none", "indentation", "tags"};
inline constexpr std::string_view kBlanks = " \t\v\f\r\n";

/// A value after the names of what contains it, except its block: "film width 640". Of tags, an
/// element with a name goes by it; the value and the type of an element follow its name, its x, y
/// and z are one value, and other attributes are values in it.
struct NestedRow {
  std::string words;
  std::size_t line = 1;
  bool begins = false;  ///< Whether it is the first of a block: an outermost item or element.
};

/// The rows of a text. Of a text with mistakes, those that can be told.
std::vector<NestedRow> nested_rows(Nesting nesting, std::string_view text,
                                   std::string_view comments);

}  // namespace raycheck::scene
