#include <stdexcept>
#include <string>

#include "scene/files/scene_file.h"
#include "scene/text.h"
#include "scene/validate.h"
#include "tests/fuzz/targets.h"

namespace raycheck::tests {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

void require_read_back(const scene::Scene& read) {
  require(scene::defects(read).empty(), "a scene that is not valid was read");
  require(scene::read_toml(scene::write_toml(read), "again.toml").scene == read,
          "a scene is another when written and read again");
}

}  // namespace

void fuzz_toml_scene(std::string_view bytes) {
  try {
    require_read_back(scene::read_toml(bytes, "f.toml").scene);
  } catch (const scene::SceneFileError&) {
  }
}

void fuzz_driver_file(std::string_view bytes) {
  const std::string shown = scene::visible(bytes);
  require(scene::visible(shown) == shown, "what is shown is shown otherwise");
  try {
    require_read_back(scene::read_driver_file(bytes, "f.txt").scene);
  } catch (const scene::SceneFileError&) {
  }
}

}  // namespace raycheck::tests
