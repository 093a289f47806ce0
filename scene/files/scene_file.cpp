#include "scene/files/scene_file.h"

#include "scene/files/file_text.h"

namespace raycheck::scene {

LoadedScene load_scene(const std::filesystem::path& path, std::optional<Dialect> dialect) {
  const std::string text = file_text(path);
  if (path.extension() != ".toml") return read_driver_file(text, path.string(), dialect);
  LoadedScene loaded = read_toml(text, path.string());
  if (dialect) {
    loaded.warnings.push_back(path.string() +
                              ": a dialect was asked for, but only driver files have one");
  }
  return loaded;
}

}  // namespace raycheck::scene
