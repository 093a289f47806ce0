#include <algorithm>
#include <cmath>

#include "scene/files/scene_file.h"
#include "scene/number.h"

namespace raycheck::scene {
namespace {

// Up to here whole doubles are written as digits that any TOML reader reads as that integer.
constexpr double kMaxWholeNumber = 1e15;

std::string toml_number(double value) {
  const std::string text = shortest(value);
  const bool is_integer = text.find_first_not_of("-0123456789") == std::string::npos;
  const bool is_negative_zero = value == 0 && std::signbit(value);
  const bool needs_point = is_integer && (is_negative_zero || std::abs(value) > kMaxWholeNumber);
  return needs_point ? text + ".0" : text;
}

template <typename Triple>
std::string toml_triple(const Triple& triple) {
  return "[" + toml_number(triple.x) + ", " + toml_number(triple.y) + ", " + toml_number(triple.z) +
         "]";
}

std::string line(std::string_view key, const std::string& value) {
  return std::string(key) + " = " + value + "\n";
}

template <typename Choice>
std::string line_unless_default(std::string_view key, Choice choice, Choice usual) {
  return choice == usual ? "" : line(key, '"' + std::string(name(choice)) + '"');
}

std::string comment_lines(std::string_view comment) {
  std::string out;
  while (!comment.empty()) {
    const std::string_view text = comment.substr(0, comment.find('\n'));
    comment.remove_prefix(std::min(text.size() + 1, comment.size()));
    out += text.empty() ? "#" : "# ";
    for (const char c : text) {
      const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
      out += is_control ? ' ' : c;
    }
    out += '\n';
  }
  return out;
}

std::string camera_table(const Camera& camera) {
  return "[camera]\n" + line("eye", toml_triple(camera.eye)) +
         line("look_at", toml_triple(camera.look_at)) + line("up", toml_triple(camera.up)) +
         line("near", toml_number(camera.near)) +
         (camera.far ? line("far", toml_number(*camera.far)) : "") +
         line("left", toml_number(camera.left)) + line("right", toml_number(camera.right)) +
         line("bottom", toml_number(camera.bottom)) + line("top", toml_number(camera.top)) +
         line("width", std::to_string(camera.width)) +
         line("height", std::to_string(camera.height));
}

std::string number_unless_default(const char* key, double value, double usual) {
  return value == usual ? "" : line(key, toml_number(value));
}

std::string conventions_table(const Conventions& conventions) {
  const Conventions usual;
  if (conventions == usual) return "";
  return "[conventions]\n" + line_unless_default("rows", conventions.rows, usual.rows) +
         line_unless_default("samples", conventions.samples, usual.samples) +
         line_unless_default("origin", conventions.origin, usual.origin) +
         line_unless_default("root", conventions.root, usual.root) +
         line_unless_default("tangent", conventions.tangent, usual.tangent) +
         number_unless_default("t_min", conventions.valid.t_min, usual.valid.t_min) +
         number_unless_default("t_max", conventions.valid.t_max, usual.valid.t_max) +
         line_unless_default("interval", conventions.valid.ends, usual.valid.ends) +
         line_unless_default("t_unit", conventions.valid.unit, usual.valid.unit) +
         line_unless_default("culling", conventions.valid.culling, usual.valid.culling);
}

}  // namespace

std::string write_toml(const Scene& scene, std::string_view comment) {
  std::string out = comment_lines(comment);
  const auto append = [&out](const std::string& table) {
    if (!out.empty() && !table.empty()) out += '\n';
    out += table;
  };
  if (scene.camera) append(camera_table(*scene.camera));
  append(conventions_table(scene.conventions));
  for (const Sphere& sphere : scene.spheres) {
    append("[[sphere]]\n" + line("centre", toml_triple(sphere.centre)) +
           line("radius", toml_number(sphere.radius)));
  }
  for (const Ray& ray : scene.rays) {
    append("[[ray]]\n" + line("origin", toml_triple(ray.origin)) +
           line("direction", toml_triple(ray.direction)));
  }
  return out;
}

}  // namespace raycheck::scene
