#pragma once

#include <string>
#include <string_view>

namespace raycheck::scene {

/// Text of files, candidates and names, in which nothing acts on what shows it: valid UTF-8, each
/// byte that is none replaced by U+FFFD, and control characters (those of C1 and those that change
/// the direction of writing, too) spelled: \x1b, \u202e. Ends of lines and tabs stay.
std::string visible(std::string_view text);

/// The same on one line: ends of lines and tabs are spelled, too.
std::string visible_line(std::string_view text);

}  // namespace raycheck::scene
