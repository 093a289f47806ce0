#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "scene/text.h"

namespace raycheck::scene {

/// The three dialects of the course's driver files.
/// A (2017-18): `d` > 0 is the distance to the plane, `bounds left bottom right top`.
/// B (2019): `d` < 0 is near, `bounds left right bottom top`.
/// C (2020-21): like B, but with one line `camera ex ey ez lx ly lz ux uy uz d`.
enum class Dialect { kA, kB, kC };
inline constexpr std::array<std::string_view, 3> kDialectNames = {"A", "B", "C"};
constexpr std::string_view name(Dialect dialect) {
  return kDialectNames[static_cast<std::size_t>(dialect)];
}

/// A file that cannot be read as a scene; what() names file, line, field and value.
class SceneFileError : public std::runtime_error {
 public:
  explicit SceneFileError(const std::string& what) : std::runtime_error(visible(what)) {}
};

/// A scene, and warnings about its file that did not prevent reading it.
struct LoadedScene {
  Scene scene;
  std::vector<std::string> warnings;
  std::optional<Dialect> dialect = {};  ///< The dialect of a driver file.
  std::string format = {};  ///< The format of a file (scene/formats/); empty for others.
  /// Parts of the file that are ignored because only shading needs them: "ambient", "2
  /// lights".
  std::vector<std::string> not_needed = {};
};

struct FileFormat;

/// How a file is to be read if its name does not tell: in a format, or as a driver file, of a
/// dialect that is used if its contents do not determine it.
struct ReadAs {
  ReadAs() = default;
  ReadAs(Dialect its_dialect) : dialect(its_dialect) {}
  ReadAs(const FileFormat* its_format) : format(its_format) {}
  std::optional<Dialect> dialect = {};
  const FileFormat* format = nullptr;
};

/// Reads a scene file: TOML if the name ends in ".toml"; in the format to which the name's ending
/// belongs; otherwise a driver file.
/// Domain: the scene is valid (scene/validate.h); otherwise throws SceneFileError.
LoadedScene load_scene(const std::filesystem::path& path, const ReadAs& as = {});

/// Reads a scene from text; `file` is the name of the file in errors and warnings.
LoadedScene read_toml(std::string_view text, std::string_view file);
LoadedScene read_driver_file(std::string_view text, std::string_view file,
                             std::optional<Dialect> dialect = {});

/// A scene as TOML. Numbers are the shortest decimals that read back as the same double. The lines
/// of `comment` come first.
std::string write_toml(const Scene& scene, std::string_view comment = {});

}  // namespace raycheck::scene
