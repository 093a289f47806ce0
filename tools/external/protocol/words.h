#pragma once

// The words of the lines that raycheck and a candidate's process exchange (docs/candidates.md).
// Both sides parse them with this header, so that raycheck-worker links nothing else of raycheck.

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "scene/conventions.h"
#include "scene/number.h"

namespace raycheck::tools {

inline constexpr std::array<std::string_view, 6> kFunctions = {
    "frame", "pixel_point", "pixel_ray", "focal_ray", "intersect", "nearest"};

/// A convention in a `conventions` line, and its values in the order of the enumerators.
struct ConventionWords {
  std::string_view name;
  std::span<const std::string_view> values;
};
inline constexpr std::array<ConventionWords, 5> kConventionWords = {
    {{"rows", scene::kRowsNames},
     {"samples", scene::kSamplesNames},
     {"origin", scene::kOriginNames},
     {"root", scene::kRootNames},
     {"tangent", scene::kTangentNames}}};

/// The ends of an interval as one word, in the order of scene::Ends, and "as-asked" for any
/// interval.
inline constexpr std::array<std::string_view, 5> kEndsWords = {"[]", "[)", "(]", "()", "as-asked"};

/// The words for the directions that a candidate accepts.
inline constexpr std::array<std::string_view, 2> kDirectionsWords = {"any", "unit"};

/// A malformed line; what() names the line and its fault.
class ProtocolError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The most characters shown of a line, and of an error's message.
inline constexpr std::size_t kShownLine = 60, kShownError = 200;

/// A line for error messages, without terminal control sequences.
inline std::string shown(std::string_view line, std::size_t most = kShownLine) {
  std::string text(line.substr(0, most));
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return line.size() > most ? text + "..." : text;
}

/// The words of a line, one after the other. Errors: ProtocolError.
class Words {
 public:
  Words(std::string_view line, std::size_t number) : line_(line), rest_(line), number_(number) {}

  std::string_view word() {
    if (rest_.empty()) fail("has too few words");
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return found;
  }
  double number() {
    const auto value = scene::parse_number(word());
    if (!value) fail("has a word that is not a number");
    return *value;
  }
  std::int64_t integer(const char* otherwise = "has a word that is not a whole number") {
    const std::string_view text = word();
    std::int64_t value = 0;
    const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || at != text.data() + text.size()) fail(otherwise);
    return value;
  }
  template <class Triple>
  Triple triple() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  /// The index of the next word in `names`.
  std::size_t place_in(std::span<const std::string_view> names, const char* otherwise) {
    const auto found = std::ranges::find(names, word());
    if (found == names.end()) fail(otherwise);
    return static_cast<std::size_t>(found - names.begin());
  }
  void end() const {
    if (!rest_.empty()) fail("has too many words");
  }
  [[noreturn]] void fail(const std::string& how) const {
    throw ProtocolError("line " + std::to_string(number_) + " of its reply " + how + ": '" +
                        shown(line_) + "'");
  }

 private:
  std::string_view line_, rest_;
  std::size_t number_;
};

}  // namespace raycheck::tools
