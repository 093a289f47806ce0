#include "scene/files/scene_file.h"

#include "scene/files/file_text.h"
#include "scene/files/format.h"
#include "scene/files/toml_fields.h"
#include "scene/interruption.h"

namespace raycheck::scene {
namespace {

class SceneReader {
 public:
  explicit SceneReader(std::string_view file) : fields_(file) {}

  Scene read_scene(const toml::table& root) {
    const Table file{root, "scene", "", 1};
    fields_.require_known(file, {"camera", "conventions", "sphere", "ray"});
    Scene scene;
    if (const auto field = fields_.optional(file, "camera")) {
      scene.camera = read<Camera>(fields_.table(*field));
    }
    if (const auto field = fields_.optional(file, "conventions")) {
      read_conventions(fields_, fields_.table(*field), scene.conventions);
    }
    for (const Table& each : fields_.tables(file, "sphere")) {
      poll();
      scene.spheres.push_back(read<Sphere>(each));
    }
    for (const Table& each : fields_.tables(file, "ray")) {
      poll();
      scene.rays.push_back(read<Ray>(each));
    }
    fields_.located().require_valid(scene, [&](const std::string& field) {
      // The defect "scene" is reported if there are rays as well as a camera.
      const auto given = root.at_path(field == "scene" ? "ray[0]" : field);
      return given ? std::optional<std::size_t>(given.node()->source().begin.line) : std::nullopt;
    });
    return scene;
  }

 private:
  using Table = TomlFields::Table;

  template <class Thing>
  Thing read(const Table& from) {
    Thing thing;
    std::vector<std::string_view> known;
    for_each_field(thing, [&](std::string_view key, auto&) { known.push_back(key); });
    fields_.require_known(from, known);
    for_each_field(thing, [&](std::string_view key, auto& value) { set(from, key, value); });
    return thing;
  }

  template <class Triple>
  void set(const Table& from, std::string_view key, Triple& value) const {
    value = fields_.triple<Triple>(fields_.required(from, key));
  }
  void set(const Table& from, std::string_view key, double& value) const {
    value = fields_.number(fields_.required(from, key));
  }
  void set(const Table& from, std::string_view key, std::optional<double>& value) const {
    if (const auto field = fields_.optional(from, key)) value = fields_.number(*field);
  }
  void set(const Table& from, std::string_view key, std::int64_t& value) const {
    value = fields_.integer(fields_.required(from, key), "a whole number of pixels");
  }

  TomlFields fields_;
};

}  // namespace

LoadedScene read_toml(std::string_view text, std::string_view file) {
  return {SceneReader(file).read_scene(parse_toml(text, file)), {}};
}

LoadedScene load_scene(const std::filesystem::path& path, const FileFormat* format) {
  const std::string text = file_text(path);
  if (path.extension() != ".toml") return read_any_format(text, path.string(), format);
  LoadedScene loaded = read_toml(text, path.string());
  if (format != nullptr) {
    loaded.warnings.push_back(path.string() +
                              ": a dialect was given, but only driver files have one");
  }
  return loaded;
}

}  // namespace raycheck::scene
