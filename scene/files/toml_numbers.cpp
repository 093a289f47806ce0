#include "scene/files/toml_numbers.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "scene/number.h"

namespace raycheck::scene {
namespace {

bool is_hex_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

bool is_token_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '+' || c == '-' || c == '.' || c == ':';
}

// The token without its digit separators, if it is a decimal or a hexfloat.
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
      if (nesting_.size() > kMostNested) fail("lists and tables inside each other");
      expects_value_ = c == '[';
    }
    if ((c == ']' && inside == '[') || (c == '}' && inside == '{')) {
      nesting_.pop_back();
      expects_value_ = false;
    }
  }

  /// Counts dots since the last end of a key or a value: a key has at most one part more.
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

}  // namespace

std::string with_numbers_quoted(std::string_view toml, const LocatedFields& located) {
  return Quoter(toml, located).quoted();
}

}  // namespace raycheck::scene
