#pragma once

// Shared by the readers of TOML files. No other code includes toml++.

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/conventions.h"
#include "scene/fields.h"
#include "scene/files/located_fields.h"
#include "scene/text.h"

namespace raycheck::scene {

/// The limit on the nesting of lists and tables and on the parts of a key (a.b.c has 3). toml++
/// recurses into each, so that a line with too many would overflow the stack.
inline constexpr std::size_t kMostNested = 32;

/// Parses TOML. Every bare decimal and hexfloat value is first put in quotes, without its
/// digit-separating underscores, so that parse_number reads it later: toml++ 3.3 refuses decimals
/// that underflow or exceed 128 characters, and reads hexfloats through 32-bit integers. Keys,
/// strings, comments, dates, words and integers in other bases stay as they are.
/// Errors: SceneFileError naming the line, also if the nesting exceeds kMostNested.
toml::table parse_toml(std::string_view text, std::string_view file);

/// Reads the fields of a TOML file, by kind. Every error names file, line, field and value.
class TomlFields {
 public:
  /// A value in the file, and its name in errors.
  struct Field {
    const toml::node& node;
    std::string name;
    std::size_t line;
  };

  /// A table in the file. Errors put `prefix` before its keys.
  struct Table {
    const toml::table& keys;
    std::string name;
    std::string prefix;
    std::size_t line;
  };

  explicit TomlFields(std::string_view file) : located_(file) {}

  LocatedFields& located() { return located_; }

  void require_known(const Table& from, std::span<const std::string_view> known);
  void require_known(const Table& from, std::initializer_list<std::string_view> known) {
    require_known(from, std::span(known.begin(), known.size()));
  }
  std::optional<Field> optional(const Table& from, std::string_view key) const;
  Field required(const Table& from, std::string_view key) const;

  Table table(const Field& field) const;
  std::vector<Table> tables(const Table& from, std::string_view key) const;
  double number(const Field& field) const;
  /// `meaning`: "a whole number of pixels".
  std::int64_t integer(const Field& field, std::string_view meaning) const;
  std::string text(const Field& field) const;
  bool flag(const Field& field) const;
  /// The elements of an array, as fields.
  std::vector<Field> list(const Field& field) const;
  std::vector<std::string> texts(const Field& field) const;

  template <typename Triple>
  Triple triple(const Field& field) const {
    const auto* array = field.node.as_array();
    if (!array || array->size() != 3) fail(field, "must be 3 numbers, written [x, y, z]");
    const auto elements = list(field);
    return {number(elements[0]), number(elements[1]), number(elements[2])};
  }

  /// Sets a choice to the enumerator that the file names; without the key, the choice stays.
  template <typename Choice, std::size_t kCount>
  void choose(const Table& from, std::string_view key,
              const std::array<std::string_view, kCount>& names, Choice& choice) const {
    if (const auto field = optional(from, key)) choice = chosen<Choice>(*field, names);
  }
  template <typename Choice, std::size_t kCount>
  void choose(const Table& from, std::string_view key,
              const std::array<std::string_view, kCount>& names,
              std::optional<Choice>& choice) const {
    if (const auto field = optional(from, key)) choice = chosen<Choice>(*field, names);
  }

  [[noreturn]] void fail(const Field& field, std::string_view what) const;

 private:
  template <typename Choice, typename Names>
  Choice chosen(const Field& field, const Names& names) const {
    const auto* text = field.node.as_string();
    const auto found = text ? std::ranges::find(names, text->get()) : names.end();
    if (found == names.end()) fail(field, "must be one of " + joined(names));
    return static_cast<Choice>(found - names.begin());
  }

  LocatedFields located_;
};

/// The conventions that a table sets, in a scene or another file. If one field of valid roots is
/// given, all count as declared. The caller reads the choices of the names `except`.
template <typename Conventions>
void read_conventions(TomlFields& fields, const TomlFields::Table& from, Conventions& conventions,
                      std::span<const std::string_view> except = {}) {
  ValidRoots valid = std::optional<ValidRoots>(conventions.valid).value_or(ValidRoots{});
  std::vector<std::string_view> known;
  const auto note = [&](std::string_view key, auto&) { known.push_back(key); };
  for_each_choice(conventions, note);
  for_each_field(valid, note);
  fields.require_known(from, known);

  for_each_choice(conventions, [&](std::string_view key, auto& choice) {
    using Choice = std::remove_cvref_t<decltype(choice)>;
    if (std::ranges::find(except, key) != except.end()) return;
    if constexpr (std::is_enum_v<Choice>) {
      fields.choose(from, key, names_of(choice), choice);
    } else {
      fields.choose(from, key, names_of(typename Choice::value_type{}), choice);
    }
  });
  for_each_field(valid, [&](std::string_view key, auto& value) {
    const auto field = fields.optional(from, key);
    if (!field) return;
    if constexpr (std::is_enum_v<std::remove_reference_t<decltype(value)>>) {
      fields.choose(from, key, names_of(value), value);
    } else {
      value = fields.number(*field);
    }
    conventions.valid = valid;
  });
}

}  // namespace raycheck::scene
