#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <string_view>

namespace raycheck::scene {

/// The format that a candidate computes in and is judged in. Its inputs are numbers of this format
/// (floats are passed as doubles), and its errors are counted in ulp and u of this format.
enum class Precision { kDouble, kSingle };
inline constexpr std::array<std::string_view, 2> kPrecisionNames = {"double", "single"};
constexpr auto& names_of(Precision /*of*/) { return kPrecisionNames; }
constexpr std::string_view name(Precision value) {
  return kPrecisionNames[static_cast<std::size_t>(value)];
}

/// A binary format of IEEE-754.
struct Format {
  int digits;          ///< p
  int least_exponent;  ///< The least number above 0 is 2^least_exponent.
};
inline constexpr std::array<Format, 2> kFormats = {{{53, -1074}, {24, -149}}};
constexpr Format format_of(Precision precision) {
  return kFormats[static_cast<std::size_t>(precision)];
}

/// u: half the gap between 1 and the next larger number, 2^-53 or 2^-24.
constexpr double unit_roundoff(Precision precision) {
  return precision == Precision::kSingle ? 0x1p-24 : 0x1p-53;
}

/// The unit of an error: ulp, the gap between the numbers of a format at the exact value; or u
/// times the size of the exact value.
enum class Unit { kUlp, kU };

/// An error in ulp or u of a format.
struct Measured {
  double value = 0;
  Unit unit = Unit::kU;
  Precision format = Precision::kDouble;

  /// The error in u of another format. Errors in ulp stay as they are.
  constexpr Measured in(Precision other) const {
    if (unit == Unit::kUlp || format == other) return *this;
    return {value * (unit_roundoff(format) / unit_roundoff(other)), unit, other};
  }
  /// Compares errors in the same unit.
  auto operator<=>(const Measured&) const = default;
};

/// A double rounded to the format: to nearest, ties to even; infinite beyond the format's range.
double rounded_to(Precision precision, double x);

/// The number of the format next to x in the direction of `toward`. Domain: x is of the format.
double next_after(Precision precision, double x, double toward);

}  // namespace raycheck::scene
