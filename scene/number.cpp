#include "scene/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace raycheck::scene {
namespace {

constexpr std::string_view kHexDigitsAndPoint = "0123456789abcdefABCDEF.";
constexpr long long kExponentLimit = 1'000'000'000'000'000;

// Whether a number outside the range of doubles is too large, not too small. The sign of its power
// is enough, estimated from the place of its first nonzero digit and its exponent.
bool is_above_range(std::string_view text, bool is_hex) {
  const std::size_t marker = text.find_first_of(is_hex ? "pP" : "eE");
  const std::string_view mantissa = text.substr(0, marker);
  const std::size_t first = mantissa.find_first_not_of("0.");
  if (first == std::string_view::npos) return false;
  long long exponent = 0;
  if (marker != std::string_view::npos) {
    std::string_view digits = text.substr(marker + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (read.ec != std::errc{}) return !digits.starts_with('-');
  }
  const auto point = static_cast<long long>(std::min(mantissa.find('.'), mantissa.size()));
  const long long place = point - static_cast<long long>(first);
  return std::clamp(exponent, -kExponentLimit, kExponentLimit) + (is_hex ? 4 : 1) * place > 0;
}

template <typename... Format>
std::string characters(double value, Format... format) {
  std::array<char, 64> buffer{};
  const auto written =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
  return {buffer.data(), written.ptr};
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
  if (is_hex) text.remove_prefix(2);
  if (text.empty() || text.front() == '-') return std::nullopt;
  if (is_hex && kHexDigitsAndPoint.find(text.front()) == std::string_view::npos)
    return std::nullopt;
  double magnitude = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), magnitude,
                                    is_hex ? std::chars_format::hex : std::chars_format::general);
  if (read.ec == std::errc::invalid_argument || read.ptr != text.data() + text.size()) {
    return std::nullopt;
  }
  if (read.ec == std::errc::result_out_of_range) {
    magnitude = is_above_range(text, is_hex) ? std::numeric_limits<double>::infinity() : 0.0;
  }
  return is_negative ? -magnitude : magnitude;
}

std::string shortest(double value) { return std::isnan(value) ? "nan" : characters(value); }

double to_digits(double value, int digits) {
  return *parse_number(characters(value, std::chars_format::scientific, digits - 1));
}

std::string hexfloat(double value) {
  if (!std::isfinite(value)) return shortest(value);
  const int power = value == 0 ? 0 : std::ilogb(value);
  // Scaled to [1, 2), since libraries differ in how they write subnormal numbers.
  std::string text = characters(std::scalbn(std::abs(value), -power), std::chars_format::hex);
  text.resize(text.find('p') + 1);
  return (std::signbit(value) ? "-0x" : "0x") + text + (power < 0 ? "" : "+") +
         std::to_string(power);
}

std::string digits_and_hexfloat(double value) {
  if (!std::isfinite(value)) return shortest(value);
  return characters(value, std::chars_format::general, 17) + " (" + hexfloat(value) + ")";
}

}  // namespace raycheck::scene
