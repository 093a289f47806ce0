#include <algorithm>
#include <cmath>
#include <type_traits>

#include "scene/fields.h"
#include "scene/files/scene_file.h"
#include "scene/number.h"

namespace raycheck::scene {
namespace {

// Whole doubles up to this are written as digits, which every TOML reader reads as the integer.
constexpr double kMaxWholeNumber = 1e15;

std::string toml_number(double value) {
  const std::string text = shortest(value);
  const bool is_integer = text.find_first_not_of("-0123456789") == std::string::npos;
  const bool is_negative_zero = value == 0 && std::signbit(value);
  const bool needs_point = is_integer && (is_negative_zero || std::abs(value) > kMaxWholeNumber);
  return needs_point ? text + ".0" : text;
}

template <class Value>
std::string toml_value(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return '"' + std::string(name(value)) + '"';
  } else if constexpr (std::is_same_v<Value, double>) {
    return toml_number(value);
  } else if constexpr (std::is_same_v<Value, std::int64_t>) {
    return std::to_string(value);
  } else {
    return "[" + toml_number(value.x) + ", " + toml_number(value.y) + ", " + toml_number(value.z) +
           "]";
  }
}

template <class Value>
std::string line(const char* key, const Value& value) {
  return std::string(key) + " = " + toml_value(value) + "\n";
}
std::string line(const char* key, const std::optional<double>& value) {
  return value ? line(key, *value) : "";
}

template <class Thing>
std::string table(const char* header, const Thing& thing) {
  std::string out = std::string(header) + "\n";
  for_each_field(thing, [&](const char* key, const auto& value) { out += line(key, value); });
  return out;
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

std::vector<std::string> lines_of(const Conventions& conventions) {
  std::vector<std::string> lines;
  const auto add = [&](const char* key, const auto& value) { lines.push_back(line(key, value)); };
  for_each_choice(conventions, add);
  for_each_field(conventions.valid, add);
  return lines;
}

/// The conventions that differ from the defaults.
std::string conventions_table(const Conventions& conventions) {
  const Conventions usual;
  if (conventions == usual) return "";
  std::string out = "[conventions]\n";
  const std::vector<std::string> lines = lines_of(conventions), defaults = lines_of(usual);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (lines[k] != defaults[k]) out += lines[k];
  }
  return out;
}

}  // namespace

std::string write_toml(const Scene& scene, std::string_view comment) {
  std::string out = comment_lines(comment);
  const auto append = [&out](const std::string& table) {
    if (!out.empty() && !table.empty()) out += '\n';
    out += table;
  };
  if (scene.camera) append(table("[camera]", *scene.camera));
  append(conventions_table(scene.conventions));
  for (const Sphere& sphere : scene.spheres) append(table("[[sphere]]", sphere));
  for (const Ray& ray : scene.rays) append(table("[[ray]]", ray));
  return out;
}

}  // namespace raycheck::scene
