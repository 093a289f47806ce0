#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "scene/files/located_fields.h"

namespace raycheck::scene {

/// The deepest nesting of lists and tables, and the most parts of a key (a.b.c has 3): toml++
/// recurses on each, so a line with too many overflows the stack.
inline constexpr std::size_t kMostNested = 32;

/// The TOML text with every bare decimal and hexfloat value put in quotes, without its
/// digit-separating underscores; line numbers stay. A TOML parser then passes on the digits
/// themselves, so that parse_number alone decides how they round: toml++ 3.3 refuses decimals that
/// underflow or exceed 128 characters, and reads hexfloats through 32-bit integers. Keys, strings,
/// comments, dates, words and integers in other bases stay as they are, and so does invalid TOML,
/// which the parser reports.
/// Errors: SceneFileError naming the line where nesting exceeds kMostNested.
std::string with_numbers_quoted(std::string_view toml, const LocatedFields& located);

}  // namespace raycheck::scene
