#include "scene/files/toml_fields.h"

#include "scene/files/toml_numbers.h"
#include "scene/number.h"

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

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view file) {
  const LocatedFields located(file);
  try {
    return toml::parse(with_numbers_quoted(text, located));
  } catch (const toml::parse_error& error) {
    located.fail(error.source().begin.line, "not valid TOML", error.description());
  }
}

void TomlFields::require_known(const Table& from, std::span<const std::string_view> known) {
  std::optional<Field> unknown;
  for (const auto& [key, node] : from.keys) {
    const Field field{node, from.prefix + std::string(key.str()), key.source().begin.line};
    const bool is_known = std::find(known.begin(), known.end(), key.str()) != known.end();
    if (!is_known && (!unknown || field.line < unknown->line)) unknown.emplace(field);
  }
  if (unknown) {
    located_.fail(unknown->line, unknown->name, spelled(unknown->node),
                  "unknown key; " + from.name + " knows " + listed(known));
  }
}

std::optional<TomlFields::Field> TomlFields::optional(const Table& from,
                                                      std::string_view key) const {
  const auto found = from.keys.find(key);
  if (found == from.keys.end()) return std::nullopt;
  return Field{found->second, from.prefix + std::string(key), found->first.source().begin.line};
}

TomlFields::Field TomlFields::required(const Table& from, std::string_view key) const {
  if (auto field = optional(from, key)) return *field;
  located_.fail(from.line, from.prefix + std::string(key), "is missing");
}

TomlFields::Table TomlFields::table(const Field& field) const {
  const auto* keys = field.node.as_table();
  if (!keys) fail(field, "must be a table, written [" + field.name + "]");
  return {*keys, field.name, field.name + ".", field.line};
}

std::vector<TomlFields::Table> TomlFields::tables(const Table& from, std::string_view key) const {
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

double TomlFields::number(const Field& field) const {
  if (const auto value = number_in(field.node)) return *value;
  fail(field, "must be a number");
}

std::int64_t TomlFields::integer(const Field& field, std::string_view meaning) const {
  if (const auto* value = field.node.as_integer()) return value->get();
  if (const auto* text = field.node.as_string()) {
    if (const auto value = parse_integer(text->get())) return *value;
  }
  fail(field, "must be " + std::string(meaning) + ", without a point or exponent");
}

std::string TomlFields::text(const Field& field) const {
  const auto* const text = field.node.as_string();
  if (text == nullptr) fail(field, "must be a text in quotes");
  // Paths, command-line words and errors end at a NUL.
  if (text->get().find('\0') != std::string::npos) fail(field, "must be without NUL");
  return text->get();
}

bool TomlFields::flag(const Field& field) const {
  if (const auto* flag = field.node.as_boolean()) return flag->get();
  fail(field, "must be true or false");
}

std::vector<TomlFields::Field> TomlFields::list(const Field& field) const {
  const auto* array = field.node.as_array();
  if (!array) fail(field, "must be a list, written [...]");
  std::vector<Field> elements;
  for (const toml::node& node : *array) {
    elements.push_back(
        {node, field.name + "[" + std::to_string(elements.size()) + "]", field.line});
  }
  return elements;
}

std::vector<std::string> TomlFields::texts(const Field& field) const {
  std::vector<std::string> result;
  for (const Field& element : list(field)) result.push_back(text(element));
  return result;
}

void TomlFields::fail(const Field& field, std::string_view what) const {
  located_.fail(field.line, field.name, spelled(field.node), what);
}

}  // namespace raycheck::scene
