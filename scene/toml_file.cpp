#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>

#include "scene/located_fields.h"
#include "scene/number.h"
#include "scene/scene_file.h"
#include "scene/toml_numbers.h"

namespace raycheck::scene {
namespace {

std::string spelled(const toml::node& node) {
  if (const auto* text = node.as_string()) {
    return parse_number(text->get()) ? text->get() : '"' + text->get() + '"';
  }
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* integer = node.as_integer()) return std::to_string(integer->get());
  if (const auto* number = node.as_floating_point()) return shortest(number->get());
  if (node.is_table()) return "(a table)";
  if (node.is_array_of_tables()) return "(an array of tables)";
  const auto* array = node.as_array();
  if (!array) return "(a date or time)";
  std::string list;
  for (const toml::node& element : *array) list += (list.empty() ? "" : ", ") + spelled(element);
  return "[" + list + "]";
}

std::optional<double> number_in(const toml::node& node) {
  if (const auto* text = node.as_string()) return parse_number(text->get());
  if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
  if (const auto* number = node.as_floating_point()) return number->get();
  return std::nullopt;
}

template <typename Names>
std::string listed(const Names& names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

// A value in the file, and what errors call it.
struct Field {
  const toml::node& node;
  std::string name;
  std::size_t line;
};

// A table in the file: `prefix` comes before its keys' names in errors.
struct Table {
  const toml::table& keys;
  std::string name;
  std::string prefix;
  std::size_t line;
};

class TomlReader {
 public:
  explicit TomlReader(std::string_view file) : located_(file) {}

  Scene read(const toml::table& root) {
    const Table file{root, "scene", "", 1};
    require_known(file, {"camera", "conventions", "sphere", "ray"});
    Scene scene;
    if (const auto field = optional(file, "camera")) scene.camera = camera(table(*field));
    if (const auto field = optional(file, "conventions")) {
      scene.conventions = conventions(table(*field));
    }
    for (const Table& each : tables(file, "sphere")) scene.spheres.push_back(sphere(each));
    for (const Table& each : tables(file, "ray")) scene.rays.push_back(ray(each));
    if (scene.camera && !scene.rays.empty()) {
      located_.put("scene", optional(file, "ray")->line);
    }
    located_.require_valid(scene);
    return scene;
  }

 private:
  Camera camera(const Table& from) {
    require_known(from, {"eye", "look_at", "up", "near", "far", "left", "right", "bottom", "top",
                         "width", "height"});
    Camera camera;
    camera.eye = triple<Point3>(required(from, "eye"));
    camera.look_at = triple<Point3>(required(from, "look_at"));
    camera.up = triple<Vector3>(required(from, "up"));
    camera.near = number(required(from, "near"));
    if (const auto field = optional(from, "far")) camera.far = number(*field);
    camera.left = number(required(from, "left"));
    camera.right = number(required(from, "right"));
    camera.bottom = number(required(from, "bottom"));
    camera.top = number(required(from, "top"));
    camera.width = integer(required(from, "width"));
    camera.height = integer(required(from, "height"));
    return camera;
  }

  Conventions conventions(const Table& from) {
    require_known(from, {"rows", "samples", "origin", "root", "tangent"});
    Conventions conventions;
    choose(from, "rows", kRowsNames, conventions.rows);
    choose(from, "samples", kSamplesNames, conventions.samples);
    choose(from, "origin", kOriginNames, conventions.origin);
    choose(from, "root", kRootNames, conventions.root);
    choose(from, "tangent", kTangentNames, conventions.tangent);
    return conventions;
  }

  Sphere sphere(const Table& from) {
    require_known(from, {"centre", "radius"});
    return {triple<Point3>(required(from, "centre")), number(required(from, "radius"))};
  }

  Ray ray(const Table& from) {
    require_known(from, {"origin", "direction"});
    return {triple<Point3>(required(from, "origin")), triple<Vector3>(required(from, "direction"))};
  }

  void require_known(const Table& from, std::initializer_list<std::string_view> known) {
    std::optional<Field> unknown;
    for (const auto& [key, node] : from.keys) {
      const Field field{node, from.prefix + std::string(key.str()), key.source().begin.line};
      located_.put(field.name, field.line);
      const bool is_known = std::find(known.begin(), known.end(), key.str()) != known.end();
      if (!is_known && (!unknown || field.line < unknown->line)) unknown.emplace(field);
    }
    if (unknown) {
      located_.fail(unknown->line, unknown->name, spelled(unknown->node),
                    "unknown key; " + from.name + " knows " + listed(known));
    }
  }

  std::optional<Field> optional(const Table& from, std::string_view key) const {
    const auto found = from.keys.find(key);
    if (found == from.keys.end()) return std::nullopt;
    return Field{found->second, from.prefix + std::string(key), found->first.source().begin.line};
  }

  Field required(const Table& from, std::string_view key) const {
    if (auto field = optional(from, key)) return *field;
    located_.fail(from.line, from.prefix + std::string(key), "is missing");
  }

  Table table(const Field& field) const {
    const auto* keys = field.node.as_table();
    if (!keys) fail(field, "must be a table, written [" + field.name + "]");
    return {*keys, field.name, field.name + ".", field.line};
  }

  std::vector<Table> tables(const Table& from, std::string_view key) const {
    std::vector<Table> found;
    const auto field = optional(from, key);
    if (!field) return found;
    const auto* array = field->node.as_array();
    if (!array) fail(*field, "must be written [[" + field->name + "]]");
    for (const toml::node& element : *array) {
      const std::string name = field->name + "[" + std::to_string(found.size()) + "]";
      const Field each{element, name, element.source().begin.line};
      const auto* keys = element.as_table();
      if (!keys) fail(each, "must be a table, written [[" + field->name + "]]");
      found.push_back({*keys, field->name, name + ".", each.line});
    }
    return found;
  }

  double number(const Field& field) const {
    if (const auto value = number_in(field.node)) return *value;
    fail(field, "must be a number");
  }

  template <typename Triple>
  Triple triple(const Field& field) const {
    const auto* array = field.node.as_array();
    if (!array || array->size() != 3) fail(field, "must be 3 numbers, written [x, y, z]");
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) {
      values[i] = number({(*array)[i], field.name + "[" + std::to_string(i) + "]", field.line});
    }
    return {values[0], values[1], values[2]};
  }

  std::int64_t integer(const Field& field) const {
    if (const auto* value = field.node.as_integer()) return value->get();
    if (const auto* text = field.node.as_string()) {
      if (const auto value = parse_integer(text->get())) return *value;
    }
    fail(field, "must be a whole number of pixels, without a point or exponent");
  }

  template <typename Choice, std::size_t kCount>
  void choose(const Table& from, std::string_view key,
              const std::array<std::string_view, kCount>& names, Choice& choice) const {
    const auto field = optional(from, key);
    if (!field) return;
    const auto* text = field->node.as_string();
    const auto found = text ? std::find(names.begin(), names.end(), text->get()) : names.end();
    if (found == names.end()) fail(*field, "must be one of " + listed(names));
    choice = static_cast<Choice>(found - names.begin());
  }

  [[noreturn]] void fail(const Field& field, std::string_view what) const {
    located_.fail(field.line, field.name, spelled(field.node), what);
  }

  LocatedFields located_;
};

}  // namespace

LoadedScene read_toml(std::string_view text, std::string_view file) {
  try {
    const toml::table root = toml::parse(with_numbers_quoted(text));
    return {TomlReader(file).read(root), {}};
  } catch (const toml::parse_error& error) {
    LocatedFields(file).fail(error.source().begin.line, "not valid TOML", error.description());
  }
}

}  // namespace raycheck::scene
