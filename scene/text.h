#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace raycheck::scene {

/// Text of files, candidates and names, made safe to display: valid UTF-8, with each invalid byte
/// replaced by U+FFFD, and control characters (also C1, and those that change the writing
/// direction) escaped: \x1b, \u202e. Line ends and tabs stay.
std::string visible(std::string_view text);

/// The same on one line: line ends and tabs are escaped, too.
std::string visible_line(std::string_view text);

/// The values as `write` spells them, joined by `between`.
template <class Values, class Write = std::identity>
std::string joined(const Values& values, std::string_view between = ", ", const Write& write = {}) {
  std::string text;
  bool is_first = true;
  for (const auto& value : values) {
    if (!is_first) text += between;
    text += std::invoke(write, value);
    is_first = false;
  }
  return text;
}

}  // namespace raycheck::scene
