#include "scene/text.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace raycheck::scene {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// A character and its length in bytes.
struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  ///< 0: the text does not start with a valid character.
};

/// The first character of a nonempty text.
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char head = byte(0);
  if (head < 0x80) return {head, 1};
  const std::size_t count = head >= 0xF0 ? 4 : head >= 0xE0 ? 3 : 2;
  if (head < 0xC2 || head > 0xF4 || text.size() < count) return {};
  std::uint32_t code = head & (0x7FU >> count);
  for (std::size_t k = 1; k < count; ++k) {
    if ((byte(k) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(k) & 0x3FU);
  }
  // Invalid: an overlong form, a UTF-16 surrogate, or a number beyond the last code point.
  constexpr std::array<std::uint32_t, 5> kFirst = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_none =
      code < kFirst[count] || (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF;
  return is_none ? Character{} : Character{code, count};
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code <= 0x9F) || code == 0x061C ||
         (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

void spell(std::uint32_t code, std::string& out) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const int digits = code < 0x80 ? 2 : 4;
  out += code < 0x80 ? "\\x" : "\\u";
  for (int k = digits - 1; k >= 0; --k) out += kDigits[code >> 4 * k & 15];
}

std::string shown(std::string_view text, bool is_line) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_of(text);
    const bool stays = !is_line && (character.code == '\n' || character.code == '\t');
    if (character.bytes == 0) {
      out += kReplacement;
    } else if (is_control(character.code) && !stays) {
      spell(character.code, out);
    } else {
      out += text.substr(0, character.bytes);
    }
    text.remove_prefix(character.bytes == 0 ? 1 : character.bytes);
  }
  return out;
}

}  // namespace

std::string visible(std::string_view text) { return shown(text, false); }
std::string visible_line(std::string_view text) { return shown(text, true); }

}  // namespace raycheck::scene
