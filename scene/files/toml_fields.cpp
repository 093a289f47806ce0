#include "scene/files/toml_fields.h"

#include <algorithm>

#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {

bool is_hex_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

bool is_token_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '+' || c == '-' || c == '.' || c == ':';
}

// The token without its digit separators; empty if it is neither a decimal nor a hexfloat.
std::optional<std::string> as_number(std::string_view token) {
  std::string digits;
  for (std::size_t i = 0; i < token.size(); ++i) {
    if (token[i] != '_') {
      digits += token[i];
    } else if (i == 0 || i + 1 == token.size() || !is_hex_digit(token[i - 1]) ||
               !is_hex_digit(token[i + 1])) {
      return std::nullopt;
    }
  }
  const bool is_hex = digits.find_first_of("xX") != std::string::npos;
  if (is_hex && digits.find_first_of(".pP") == std::string::npos) return std::nullopt;
  if (!parse_number(digits)) return std::nullopt;
  return digits;
}

class Quoter {
 public:
  Quoter(std::string_view text, const LocatedFields& located) : text_(text), located_(located) {}

  std::string quoted() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        copy_until(text_.find('\n', at_));
      } else if (c == '"' || c == '\'') {
        copy_string(c);
        expects_value_ = false;
      } else if (expects_value_ && is_token_character(c)) {
        copy_token();
        expects_value_ = false;
      } else {
        follow(c);
        count(c);
        copy_until(at_ + 1);
      }
    }
    return std::move(out_);
  }

 private:
  void follow(char c) {
    const char inside = nesting_.empty() ? '\0' : nesting_.back();
    if (c == '\n' && inside == '\0') expects_value_ = false;
    if (c == '=') expects_value_ = true;
    if (c == ',') expects_value_ = inside == '[';
    if ((c == '[' || c == '{') && expects_value_) {
      nesting_ += c;
      if (nesting_.size() > kMostNested) fail("nested lists and tables");
      expects_value_ = c == '[';
    }
    if ((c == ']' && inside == '[') || (c == '}' && inside == '{')) {
      nesting_.pop_back();
      expects_value_ = false;
    }
  }

  /// Counts dots since the last key or value ended. A key has at most one part more than dots.
  void count(char c) {
    constexpr std::string_view kEnds = "\n=,[]{}";
    if (kEnds.find(c) != std::string_view::npos) dots_ = 0;
    if (c == '.' && ++dots_ >= kMostNested) fail("parts of a key");
  }

  [[noreturn]] void fail(const std::string& what) const {
    const auto lines =
        std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
    located_.fail(static_cast<std::size_t>(lines) + 1, "nesting",
                  "more than " + std::to_string(kMostNested) + " " + what + "; at most " +
                      std::to_string(kMostNested) + " are read");
  }

  void copy_until(std::size_t end) {
    const std::string_view piece = text_.substr(at_, end - at_);
    out_ += piece;
    at_ += piece.size();
  }

  void copy_string(char quote) {
    const std::string triple(3, quote);
    const bool is_multi_line = text_.substr(at_).starts_with(triple);
    std::size_t end = at_ + (is_multi_line ? 3 : 1);
    while (end < text_.size()) {
      if (is_multi_line ? text_.substr(end).starts_with(triple) : text_[end] == quote) {
        end += is_multi_line ? 3 : 1;
        while (is_multi_line && end < text_.size() && text_[end] == quote) ++end;
        break;
      }
      if (text_[end] == '\n' && !is_multi_line) break;
      end += quote == '"' && text_[end] == '\\' ? 2 : 1;
    }
    copy_until(end);
  }

  void copy_token() {
    std::size_t end = at_;
    while (end < text_.size() && is_token_character(text_[end])) ++end;
    const std::optional<std::string> number = as_number(text_.substr(at_, end - at_));
    if (number) {
      out_ += '"' + *number + '"';
      at_ = end;
    } else {
      copy_until(end);
    }
  }

  std::string_view text_;
  const LocatedFields& located_;
  std::size_t at_ = 0;
  std::string out_;
  std::string nesting_;
  std::size_t dots_ = 0;
  bool expects_value_ = false;
};

/// ": radius = abc": the line of this number, counted from 1; empty if it has no text.
std::string line_text(std::string_view text, std::size_t number) {
  for (std::size_t at = 1; at < number; ++at) {
    text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
  }
  text = text.substr(0, text.find_first_of("\r\n"));
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? "" : ": " + std::string(text.substr(first));
}

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
  return "[" + scene::joined(*array, ", ", spelled) + "]";
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
    return toml::parse(Quoter(text, located).quoted());
  } catch (const toml::parse_error& error) {
    const std::size_t line = error.source().begin.line;
    constexpr std::string_view kNoValue = "could not determine value type";
    const bool has_no_value = error.description().ends_with(kNoValue);
    located.fail(line, "not valid TOML" + line_text(text, line),
                 has_no_value ? "the value is neither a number nor true, false or in quotes"
                              : error.description());
  }
}

void TomlFields::require_known(const Table& from, std::span<const std::string_view> known) {
  std::optional<Field> unknown;
  for (const auto& [key, node] : from.keys) {
    const Field field{node, from.prefix + std::string(key.str()), key.source().begin.line};
    const bool is_known = std::ranges::find(known, key.str()) != known.end();
    if (!is_known && (!unknown || field.line < unknown->line)) unknown.emplace(field);
  }
  if (!unknown) return;
  const std::string accepted = from.name + " accepts " + joined(known);
  if (unknown->node.is_table()) {
    located_.fail(unknown->line, "[" + unknown->name + "]", "unknown table; " + accepted);
  }
  located_.fail(unknown->line, unknown->name, spelled(unknown->node), "unknown key; " + accepted);
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
  if (text == nullptr) fail(field, "must be a string in quotes");
  // A NUL would cut off paths, command-line words and errors.
  if (text->get().find('\0') != std::string::npos) fail(field, "must not contain NUL");
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
