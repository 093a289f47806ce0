#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace raycheck::scene {

/// Makes text of files, candidates and names safe to display. Each invalid byte of UTF-8 is
/// replaced by U+FFFD. Control characters (also C1 and those that change the writing direction) are
/// escaped: \x1b, \u202e. Line ends and tabs stay.
std::string visible(std::string_view text);

/// Like visible(), but line ends and tabs are escaped, too.
std::string visible_line(std::string_view text);

/// Applies `write` to each value and joins the results with `between`.
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
