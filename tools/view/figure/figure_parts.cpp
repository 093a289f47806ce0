#include "tools/view/figure/figure.h"

namespace raycheck::tools {

const std::vector<PartLine>& part_lines() {
  static const std::vector<PartLine> kLines = {
      {"frustum", {"E", "near 0", "far 0"}, "faint"},
      {"frustum", {"E", "near 1", "far 1"}, "faint"},
      {"frustum", {"E", "near 2", "far 2"}, "faint"},
      {"frustum", {"E", "near 3", "far 3"}, "faint"},
      {.layer = "frustum",
       .path = {"near 0", "near 1", "near 2", "near 3", "near 0"},
       .colour = "blue",
       .is_thick = true},
      {.layer = "frustum",
       .path = {"plane 0", "plane 1", "plane 2", "plane 3", "plane 0"},
       .colour = "blue",
       .is_dashed = true},
      {.layer = "frustum",
       .path = {"far 0", "far 1", "far 2", "far 3", "far 0"},
       .colour = "purple",
       .is_thick = true},
      {.layer = "frustum", .path = {"E", "A"}, .colour = "faint", .is_dashed = true},
      {.layer = "axes",
       .path = {"E", "U"},
       .colour = "orange",
       .is_thick = true,
       .has_arrow = true},
      {.layer = "axes", .path = {"E", "V"}, .colour = "green", .is_thick = true, .has_arrow = true},
      {.layer = "axes", .path = {"E", "W"}, .colour = "blue", .is_thick = true, .has_arrow = true},
      {.layer = "axes",
       .path = {"E", "up"},
       .colour = "gold",
       .is_dashed = true,
       .has_arrow = true},
      {.layer = "roots", .path = {"E", "P"}, .colour = "ink", .is_dashed = true},
      {.layer = "roots",
       .path = {"L", "behind"},
       .colour = "ink",
       .is_thick = true,
       .is_dashed = true},
      {.layer = "roots",
       .path = {"L", "end"},
       .colour = "ink",
       .is_thick = true,
       .has_arrow = true},
      {.layer = "roots",
       .path = {"L", "C"},
       .colour = "purple",
       .is_thick = true,
       .has_arrow = true},
      {.layer = "roots", .path = {"L", "foot"}, .colour = "blue", .is_thick = true},
      {.layer = "roots", .path = {"C", "foot"}, .colour = "faint", .is_dashed = true},
      {"roots", {"C", "near root"}, "faint"},
      {"roots", {"C", "far root"}, "faint"},
      {.layer = "roots", .path = {"near root", "foot"}, .colour = "gold", .is_thick = true},
      {.layer = "roots", .path = {"foot", "far root"}, .colour = "gold", .is_thick = true},
  };
  return kLines;
}

const std::vector<PartMark>& part_marks() {
  static const std::vector<PartMark> kMarks = {
      {"frustum", "E", "ink", "disc", 11},
      {"frustum", "A", "ink", "cross", 12},
      {"roots", "L", "ink", "square", 9},
      {"roots", "C", "purple", "cross", 9},
      {"roots", "foot", "blue", "ring", 9},
      {"roots", "near root", "orange", "diamond", 10},
      {"roots", "far root", "blue", "square", 10},
      {"roots", "double root", "orange", "diamond", 10},
      {"roots", "answer", "ink", "ring", 21},
  };
  return kMarks;
}

const std::vector<PartName>& part_names() {
  static const std::vector<PartName> kNames = {
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
  return kNames;
}

}  // namespace raycheck::tools
