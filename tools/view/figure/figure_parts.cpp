#include "tools/view/figure/figure.h"

namespace raycheck::tools {
namespace {

enum PartLook { kThin = 0, kThick = 1, kDashed = 2, kArrow = 4 };

using Places = std::vector<const char*>;

/// A line from place to place.
Json part_line(const char* layer, const Places& path, const char* colour, int look = kThin) {
  const auto is = [&](PartLook one) { return (look & one) != 0; };
  return {{"layer", layer},      {"path", path},          {"colour", colour},
          {"thick", is(kThick)}, {"dashed", is(kDashed)}, {"arrow", is(kArrow)}};
}

/// A mark at a place; `size` in pixels.
Json part_mark(const char* layer, const char* at, const char* colour, const char* shape,
               double size) {
  return {{"layer", layer}, {"at", at}, {"colour", colour}, {"shape", shape}, {"size", size}};
}

/// A name beside a place, or beside the middle of two places. It is `text` unless the place has its
/// own name.
Json part_name(const char* layer, const Places& at, const char* text, const char* colour) {
  return {{"layer", layer}, {"at", at}, {"text", text}, {"colour", colour}};
}

Json part_lines() {
  return Json::array({
      part_line("frustum", {"E", "near 0", "far 0"}, "faint"),
      part_line("frustum", {"E", "near 1", "far 1"}, "faint"),
      part_line("frustum", {"E", "near 2", "far 2"}, "faint"),
      part_line("frustum", {"E", "near 3", "far 3"}, "faint"),
      part_line("frustum", {"near 0", "near 1", "near 2", "near 3", "near 0"}, "blue", kThick),
      part_line("frustum", {"plane 0", "plane 1", "plane 2", "plane 3", "plane 0"}, "blue",
                kDashed),
      part_line("frustum", {"far 0", "far 1", "far 2", "far 3", "far 0"}, "purple", kThick),
      part_line("frustum", {"E", "A"}, "faint", kDashed),
      part_line("axes", {"E", "U"}, "orange", kThick | kArrow),
      part_line("axes", {"E", "V"}, "green", kThick | kArrow),
      part_line("axes", {"E", "W"}, "blue", kThick | kArrow),
      part_line("axes", {"E", "up"}, "gold", kDashed | kArrow),
      part_line("roots", {"E", "P"}, "ink", kDashed),
      part_line("roots", {"L", "behind"}, "ink", kThick | kDashed),
      part_line("roots", {"L", "end"}, "ink", kThick | kArrow),
      part_line("roots", {"L", "C"}, "purple", kThick | kArrow),
      part_line("roots", {"L", "foot"}, "blue", kThick),
      part_line("roots", {"C", "foot"}, "faint", kDashed),
      part_line("roots", {"C", "near root"}, "faint"),
      part_line("roots", {"C", "far root"}, "faint"),
      part_line("roots", {"near root", "foot"}, "gold", kThick),
      part_line("roots", {"foot", "far root"}, "gold", kThick),
  });
}

Json part_marks() {
  return Json::array({
      part_mark("frustum", "E", "ink", "disc", 11),
      part_mark("frustum", "A", "ink", "cross", 12),
      part_mark("roots", "L", "ink", "square", 9),
      part_mark("roots", "C", "purple", "cross", 9),
      part_mark("roots", "foot", "blue", "ring", 9),
      part_mark("roots", "near root", "orange", "diamond", 10),
      part_mark("roots", "far root", "blue", "square", 10),
      part_mark("roots", "double root", "orange", "diamond", 10),
      part_mark("roots", "answer", "ink", "ring", 21),
  });
}

/// The names of places, the most important first; if there is no room, the last are dropped.
Json part_names() {
  return Json::array({
      part_name("roots", {"near root"}, "near root", "orange"),
      part_name("roots", {"far root"}, "far root", "blue"),
      part_name("roots", {"double root"}, "double root", "orange"),
      part_name("frustum", {"E"}, "eye E, the focal point", "ink"),
      part_name("roots", {"L", "C"}, "T", "purple"),
      part_name("roots", {"L", "foot"}, "v", "blue"),
      part_name("roots", {"foot", "near root"}, "d", "gold"),
      part_name("roots", {"L"}, "L, the ray's origin", "ink"),
      part_name("roots", {"foot"}, "foot, L + v D", "blue"),
      part_name("roots", {"behind"}, "behind the origin", "ink"),
      part_name("frustum", {"A"}, "look-at point A", "ink"),
      part_name("axes", {"U"}, "U", "orange"),
      part_name("axes", {"V"}, "V", "green"),
      part_name("axes", {"W"}, "W (view-plane normal)", "blue"),
      part_name("axes", {"up"}, "up vector", "gold"),
      part_name("frustum", {"near 3"}, "near clipping plane", "blue"),
      part_name("frustum", {"near 1"}, "bounded image plane", "blue"),
      part_name("frustum", {"plane 2"}, "view plane", "blue"),
      part_name("frustum", {"far 2"}, "far clipping plane", "purple"),
      part_name("pixels", {"pixel (0, 0)"}, "pixel (0, 0)", "ink"),
  });
}

}  // namespace

Json parts_json() {
  return {{"lines", part_lines()}, {"marks", part_marks()}, {"names", part_names()}};
}

}  // namespace raycheck::tools
