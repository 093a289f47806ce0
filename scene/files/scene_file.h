#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "scene/text.h"

namespace raycheck::scene {

/// A file that cannot be read as a scene; what() names file, line, field and value.
class SceneFileError : public std::runtime_error {
 public:
  explicit SceneFileError(const std::string& what) : std::runtime_error(visible(what)) {}
};

/// A scene, and warnings about its file that did not prevent reading it.
struct LoadedScene {
  Scene scene;
  std::vector<std::string> warnings;
  std::string format = {};  ///< The format of a file (scene/formats/); empty for TOML.
  /// Parts of the file that are ignored because only shading needs them: "ambient", "2
  /// lights".
  std::vector<std::string> not_needed = {};
};

struct FileFormat;

/// Reads a scene file: TOML if the name ends in ".toml"; otherwise in a format (scene/formats/),
/// the given one, or that which format_of() finds (scene/files/format.h).
/// Domain: the scene is valid (scene/validate.h); otherwise throws SceneFileError.
LoadedScene load_scene(const std::filesystem::path& path, const FileFormat* format = nullptr);

/// Reads a scene from text; `file` is the name of the file in errors and warnings.
LoadedScene read_toml(std::string_view text, std::string_view file);

/// A scene as TOML. Numbers are the shortest decimals that read back as the same double. The lines
/// of `comment` come first.
std::string write_toml(const Scene& scene, std::string_view comment = {});

}  // namespace raycheck::scene
