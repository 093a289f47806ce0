#ifndef RAYCHECK_SCENE_FILES_TOML_NUMBERS_H_
#define RAYCHECK_SCENE_FILES_TOML_NUMBERS_H_

#include <string>
#include <string_view>

namespace raycheck::scene {

/// The TOML text with every bare decimal and hexfloat that stands as a value put in quotes, without
/// its digit-separating underscores; lines keep their numbers. A TOML parser then hands on the
/// digits themselves, so that parse_number alone decides how they round: toml++ 3.3 refuses
/// decimals that underflow or exceed 128 characters, and reads hexfloats through 32-bit integers.
/// Keys, strings, comments, dates, words and integers in other bases stay as they are, and so does
/// all that is not TOML, for the parser to name.
std::string with_numbers_quoted(std::string_view toml);

}  // namespace raycheck::scene

#endif  // RAYCHECK_SCENE_FILES_TOML_NUMBERS_H_
