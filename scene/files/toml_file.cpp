#include "scene/files/scene_file.h"
#include "scene/files/toml_fields.h"
#include "scene/interruption.h"

namespace raycheck::scene {
namespace {

class SceneReader {
 public:
  explicit SceneReader(std::string_view file) : fields_(file) {}

  Scene read(const toml::table& root) {
    const Table file{root, "scene", "", 1};
    fields_.require_known(file, {"camera", "conventions", "sphere", "ray"});
    Scene scene;
    if (const auto field = fields_.optional(file, "camera")) {
      scene.camera = camera(fields_.table(*field));
    }
    if (const auto field = fields_.optional(file, "conventions")) {
      read_conventions(fields_, fields_.table(*field), scene.conventions);
    }
    for (const Table& each : fields_.tables(file, "sphere")) {
      poll();
      scene.spheres.push_back(sphere(each));
    }
    for (const Table& each : fields_.tables(file, "ray")) {
      poll();
      scene.rays.push_back(ray(each));
    }
    fields_.located().require_valid(scene, [&](const std::string& field) {
      // Its defect is that it has rays as well as a camera.
      const auto given = root.at_path(field == "scene" ? "ray[0]" : field);
      return given ? std::optional<std::size_t>(given.node()->source().begin.line) : std::nullopt;
    });
    return scene;
  }

 private:
  using Table = TomlFields::Table;

  template <class Triple>
  Triple triple(const Table& from, std::string_view key) const {
    return fields_.triple<Triple>(fields_.required(from, key));
  }
  double number(const Table& from, std::string_view key) const {
    return fields_.number(fields_.required(from, key));
  }
  std::int64_t pixels(const Table& from, std::string_view key) const {
    return fields_.integer(fields_.required(from, key), "a whole number of pixels");
  }

  Camera camera(const Table& from) {
    fields_.require_known(from, {"eye", "look_at", "up", "near", "far", "left", "right", "bottom",
                                 "top", "width", "height"});
    Camera camera;
    camera.eye = triple<Point3>(from, "eye");
    camera.look_at = triple<Point3>(from, "look_at");
    camera.up = triple<Vector3>(from, "up");
    camera.near = number(from, "near");
    if (const auto field = fields_.optional(from, "far")) camera.far = fields_.number(*field);
    camera.left = number(from, "left");
    camera.right = number(from, "right");
    camera.bottom = number(from, "bottom");
    camera.top = number(from, "top");
    camera.width = pixels(from, "width");
    camera.height = pixels(from, "height");
    return camera;
  }

  Sphere sphere(const Table& from) {
    fields_.require_known(from, {"centre", "radius"});
    return {triple<Point3>(from, "centre"), number(from, "radius")};
  }

  Ray ray(const Table& from) {
    fields_.require_known(from, {"origin", "direction"});
    return {triple<Point3>(from, "origin"), triple<Vector3>(from, "direction")};
  }

  TomlFields fields_;
};

}  // namespace

LoadedScene read_toml(std::string_view text, std::string_view file) {
  return {SceneReader(file).read(parse_toml(text, file)), {}};
}

}  // namespace raycheck::scene
