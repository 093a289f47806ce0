#pragma once

// What figures draw between, at and beside the places that have a name: the same in every page. A
// part is drawn where all its places are there, and its layer is switched on.

#include <string_view>
#include <vector>

namespace raycheck::tools {

/// From place to place.
struct PartLine {
  std::string_view layer;
  std::vector<std::string_view> path;
  std::string_view colour;
  bool is_thick = false, is_dashed = false, has_arrow = false;
};

struct PartMark {
  std::string_view layer, at, colour, shape;
  double size = 0;  ///< Pixels.
};

/// A name beside a place, or beside the middle of two.
struct PartName {
  std::string_view layer;
  std::vector<std::string_view> at;
  std::string_view text;  ///< Unless the place brings its own.
  std::string_view colour;
};

const std::vector<PartLine>& part_lines();
const std::vector<PartMark>& part_marks();
/// The most important first: the last are left out where there is no room.
const std::vector<PartName>& part_names();

}  // namespace raycheck::tools
