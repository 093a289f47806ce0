#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::scene {

/// One meaningful line of a driver file: a keyword and the words after it.
struct DriverEntry {
  std::string keyword;
  std::vector<std::string> words;
  std::size_t line = 0;  ///< From 1.

  /// The words after the keyword, one space apart.
  std::string joined() const;
};

/// The entries of a driver file, without its comments (from # to the end of a line), whatever its
/// line endings.
std::vector<DriverEntry> driver_entries(std::string_view text);

}  // namespace raycheck::scene
