#include "properties/cases/case_text.h"

#include "scene/files/scene_file.h"

namespace raycheck::properties {

std::string scene_text(const Case& the_case, std::string_view comment) {
  std::string lines(comment);
  if (the_case.scene.camera) {
    if (!lines.empty()) lines += "\n";
    lines += "pixels:";
    for (const Pixel& pixel : the_case.pixels) {
      lines += " (" + std::to_string(pixel.i) + ", " + std::to_string(pixel.j) + ")";
    }
  }
  return scene::write_toml(the_case.scene, lines);
}

}  // namespace raycheck::properties
