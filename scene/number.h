#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace raycheck::scene {

/// Reads all of `text` as one double, rounded to nearest: decimals (`-1`, `.75`, `+2.5e-3`) and
/// hexfloats (`0x1.8p+3`). Empty if `text` is anything else. `inf` and `nan` are read, and an
/// overflow is read as infinity, so that validation can refuse them and name the field.
std::optional<double> parse_number(std::string_view text);

/// The shortest decimal that reads back as the same double.
std::string shortest(double value);

/// The value rounded to `digits` significant decimal digits, as a double. Domain: finite, digits
/// >= 1.
double to_digits(double value, int digits);

/// A point's or a vector's coordinates as shortest decimals, separated by spaces.
template <class Triple>
std::string shortest_words(const Triple& v) {
  return shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z);
}

/// C99 hexfloat, e.g. "0x1.8p+3"; reads back as the same double.
std::string hexfloat(double value);

/// 17 significant digits and the hexfloat: "0.10000000000000001 (0x1.999999999999ap-4)".
std::string digits_and_hexfloat(double value);

}  // namespace raycheck::scene
