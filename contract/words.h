#pragma once

// The words of the lines that raycheck and a candidate's process exchange (docs/candidates.md).

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "scene/conventions.h"
#include "scene/fields.h"
#include "scene/number.h"
#include "scene/scene.h"
#include "scene/text.h"

namespace raycheck::contract {

/// The functions that a candidate may implement.
inline constexpr std::array<std::string_view, 7> kFunctions = {
    "frame", "pixel_point", "pixel_ray", "focal_ray", "intersect", "nearest", "pick"};

/// The ends of an interval as one word, in the order of scene::Ends.
inline constexpr std::array<std::string_view, 4> kEndsWords = {"[]", "[)", "(]", "()"};

/// The words for an enumeration's values.
template <class Enum>
requires std::is_enum_v<Enum>
constexpr auto& words_of(Enum of) { return names_of(of); }
constexpr auto& words_of(scene::Ends /*of*/) { return kEndsWords; }

/// Calls visit(field) for each field of a struct that a line has, in the order of the line.
template <scene::Either<scene::Pixel> APixel, class Visit>
void for_each_word(APixel& pixel, Visit visit) {
  visit(pixel.i);
  visit(pixel.j);
}
template <scene::Either<scene::ValidRoots> AValidRoots, class Visit>
void for_each_word(AValidRoots& valid, Visit visit) {
  visit(valid.ends);
  visit(valid.t_min);
  visit(valid.t_max);
  visit(valid.unit);
  visit(valid.culling);
}
template <scene::Either<scene::Conventions> SomeConventions, class Visit>
void for_each_word(SomeConventions& conventions, Visit visit) {
  for_each_choice(conventions, [&](auto /*name*/, auto& field) { visit(field); });
}
/// Cameras without `far`, rays, and spheres.
template <class Thing, class Visit>
requires scene::Either<Thing, scene::Camera> || scene::Either<Thing, scene::Ray> ||
    scene::Either<Thing, scene::Sphere>
void for_each_word(Thing& thing, Visit visit) {
  scene::for_each_field(thing, [&](auto /*name*/, auto& field) {
    if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(field)>, std::optional<double>>) {
      visit(field);
    }
  });
}

/// Appends a value as words: shortest decimals, names, a struct's fields in their order.
template <class Value>
void append(std::string& line, const Value& value) {
  if constexpr (std::is_same_v<Value, double>) {
    line += scene::shortest(value);
  } else if constexpr (std::is_integral_v<Value>) {
    line += std::to_string(value);
  } else if constexpr (std::is_enum_v<Value>) {
    line += words_of(value)[static_cast<std::size_t>(value)];
  } else if constexpr (requires { value.x; }) {
    line += scene::shortest_words(value);
  } else {
    const char* between = "";
    for_each_word(value, [&](const auto& field) {
      line += between;
      append(line, field);
      between = " ";
    });
  }
}

/// A malformed line; what() names the line and its fault.
class ProtocolError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The most characters shown of a line, and of an error's message.
inline constexpr std::size_t kShownLine = 60, kShownError = 200;

/// The beginning of a line, for error messages, without terminal control sequences.
inline std::string shown(std::string_view line, std::size_t most = kShownLine) {
  std::string text(line.substr(0, most));
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return line.size() > most ? text + "..." : text;
}

/// The words of a line, one after the other. Errors: ProtocolError.
class Words {
 public:
  /// `where`: "line 3 of its reply", for errors.
  Words(std::string_view line, std::string where)
      : line_(line), rest_(line), where_(std::move(where)) {}
  Words(std::string_view line, std::size_t number)
      : Words(line, "line " + std::to_string(number) + " of its reply") {}

  std::string_view word() {
    if (rest_.empty()) fail("has too few words");
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return found;
  }
  /// Whether the next word is this one, which is then passed over.
  bool skip(std::string_view expected) {
    const bool is_next = rest_.substr(0, rest_.find(' ')) == expected;
    if (is_next) word();
    return is_next;
  }
  std::int64_t integer(const char* otherwise = "has a word that is not a whole number") {
    const std::string_view text = word();
    std::int64_t value = 0;
    const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || at != text.data() + text.size()) fail(otherwise);
    return value;
  }
  /// A number, a name of an enumeration, or the fields of a struct in their order.
  template <class Value>
  Value read() {
    Value value{};
    if constexpr (std::is_same_v<Value, double>) {
      const auto number = scene::parse_number(word());
      if (!number) fail("has a word that is not a number");
      value = *number;
    } else if constexpr (std::is_same_v<Value, std::int64_t>) {
      value = integer();
    } else if constexpr (std::is_enum_v<Value>) {
      const auto& names = words_of(value);
      const std::string_view found = word();
      const auto at = std::ranges::find(names, found);
      if (at == names.end()) {
        fail("has '" + shown(found) + "', not one of " + scene::joined(names));
      }
      value = static_cast<Value>(at - names.begin());
    } else if constexpr (requires { value.x; }) {
      for (double* const number : {&value.x, &value.y, &value.z}) *number = read<double>();
    } else {
      for_each_word(value,
                    [&](auto& field) { field = read<std::remove_reference_t<decltype(field)>>(); });
    }
    return value;
  }
  void end() const {
    if (!rest_.empty()) fail("has too many words");
  }
  [[noreturn]] void fail(const std::string& how) const {
    throw ProtocolError(where_ + " " + how + ": '" + shown(line_) + "'");
  }

 private:
  std::string_view line_, rest_;
  std::string where_;
};

}  // namespace raycheck::contract
