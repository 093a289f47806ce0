#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "scene/files/located_fields.h"

namespace raycheck::scene {

/// The most lists and tables inside each other, and the most parts of a key (a.b.c has 3): toml++
/// calls itself for each, so that a line of many overruns the stack.
inline constexpr std::size_t kMostNested = 32;

/// The TOML text with every bare decimal and hexfloat that stands as a value put in quotes, without
/// its digit-separating underscores; lines keep their numbers. A TOML parser then hands on the
/// digits themselves, so that parse_number alone decides how they round: toml++ 3.3 refuses
/// decimals that underflow or exceed 128 characters, and reads hexfloats through 32-bit integers.
/// Keys, strings, comments, dates, words and integers in other bases stay as they are, and so does
/// all that is not TOML, for the parser to name.
/// Errors: SceneFileError naming the line where something is nested deeper than kMostNested.
std::string with_numbers_quoted(std::string_view toml, const LocatedFields& located);

}  // namespace raycheck::scene
