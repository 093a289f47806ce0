#include "tools/view/figure/figure.h"

namespace raycheck::tools {
namespace {

enum PartLook { kThin = 0, kThick = 1, kDashed = 2, kArrow = 4 };

/// From place to place.
struct PartLine {
  const char* layer;
  std::vector<const char*> path;
  const char* colour;
  int look = kThin;
};
const std::vector<PartLine> kPartLines = {
    {"frustum", {"E", "near 0", "far 0"}, "faint"},
    {"frustum", {"E", "near 1", "far 1"}, "faint"},
    {"frustum", {"E", "near 2", "far 2"}, "faint"},
    {"frustum", {"E", "near 3", "far 3"}, "faint"},
    {"frustum", {"near 0", "near 1", "near 2", "near 3", "near 0"}, "blue", kThick},
    {"frustum", {"plane 0", "plane 1", "plane 2", "plane 3", "plane 0"}, "blue", kDashed},
    {"frustum", {"far 0", "far 1", "far 2", "far 3", "far 0"}, "purple", kThick},
    {"frustum", {"E", "A"}, "faint", kDashed},
    {"axes", {"E", "U"}, "orange", kThick | kArrow},
    {"axes", {"E", "V"}, "green", kThick | kArrow},
    {"axes", {"E", "W"}, "blue", kThick | kArrow},
    {"axes", {"E", "up"}, "gold", kDashed | kArrow},
    {"roots", {"E", "P"}, "ink", kDashed},
    {"roots", {"L", "behind"}, "ink", kThick | kDashed},
    {"roots", {"L", "end"}, "ink", kThick | kArrow},
    {"roots", {"L", "C"}, "purple", kThick | kArrow},
    {"roots", {"L", "foot"}, "blue", kThick},
    {"roots", {"C", "foot"}, "faint", kDashed},
    {"roots", {"C", "near root"}, "faint"},
    {"roots", {"C", "far root"}, "faint"},
    {"roots", {"near root", "foot"}, "gold", kThick},
    {"roots", {"foot", "far root"}, "gold", kThick},
};

struct PartMark {
  const char *layer, *at, *colour, *shape;
  double size;  ///< Pixels.
};
const std::vector<PartMark> kPartMarks = {
    {"frustum", "E", "ink", "disc", 11},         {"frustum", "A", "ink", "cross", 12},
    {"roots", "L", "ink", "square", 9},          {"roots", "C", "purple", "cross", 9},
    {"roots", "foot", "blue", "ring", 9},        {"roots", "near root", "orange", "diamond", 10},
    {"roots", "far root", "blue", "square", 10}, {"roots", "double root", "orange", "diamond", 10},
    {"roots", "answer", "ink", "ring", 21},
};

/// A name beside a place, or beside the middle of two.
struct PartName {
  const char* layer;
  std::vector<const char*> at;
  const char* text;  ///< Unless the place has its own.
  const char* colour;
};
/// The most important first: the last are dropped if there is no room.
const std::vector<PartName> kPartNames = {
    {"roots", {"near root"}, "near root", "orange"},
    {"roots", {"far root"}, "far root", "blue"},
    {"roots", {"double root"}, "double root", "orange"},
    {"frustum", {"E"}, "eye E, the focal point", "ink"},
    {"roots", {"L", "C"}, "T", "purple"},
    {"roots", {"L", "foot"}, "v", "blue"},
    {"roots", {"foot", "near root"}, "d", "gold"},
    {"roots", {"L"}, "L, the ray's origin", "ink"},
    {"roots", {"foot"}, "foot, L + v D", "blue"},
    {"roots", {"behind"}, "behind the origin", "ink"},
    {"frustum", {"A"}, "look-at point A", "ink"},
    {"axes", {"U"}, "U", "orange"},
    {"axes", {"V"}, "V", "green"},
    {"axes", {"W"}, "W (view-plane normal)", "blue"},
    {"axes", {"up"}, "up vector", "gold"},
    {"frustum", {"near 3"}, "near clipping plane", "blue"},
    {"frustum", {"near 1"}, "bounded image plane", "blue"},
    {"frustum", {"plane 2"}, "view plane", "blue"},
    {"frustum", {"far 2"}, "far clipping plane", "purple"},
    {"pixels", {"pixel (0, 0)"}, "pixel (0, 0)", "ink"},
};

Json line_json(const PartLine& line) {
  const auto is = [&](PartLook look) { return (line.look & look) != 0; };
  return {{"layer", line.layer}, {"path", line.path},     {"colour", line.colour},
          {"thick", is(kThick)}, {"dashed", is(kDashed)}, {"arrow", is(kArrow)}};
}

Json mark_json(const PartMark& mark) {
  return {{"layer", mark.layer},
          {"at", mark.at},
          {"colour", mark.colour},
          {"shape", mark.shape},
          {"size", mark.size}};
}

Json name_json(const PartName& name) {
  return {{"layer", name.layer}, {"at", name.at}, {"text", name.text}, {"colour", name.colour}};
}

}  // namespace

Json parts_json() {
  return {{"lines", list_json(kPartLines, line_json)},
          {"marks", list_json(kPartMarks, mark_json)},
          {"names", list_json(kPartNames, name_json)}};
}

}  // namespace raycheck::tools
