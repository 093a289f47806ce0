#pragma once

#include <string>
#include <string_view>

namespace raycheck::scene {

/// Text of files, candidates and names, made safe to display: valid UTF-8, with each invalid byte
/// replaced by U+FFFD, and control characters (also C1, and those that change the writing
/// direction) escaped: \x1b, \u202e. Line ends and tabs stay.
std::string visible(std::string_view text);

/// The same on one line: line ends and tabs are escaped, too.
std::string visible_line(std::string_view text);

}  // namespace raycheck::scene
