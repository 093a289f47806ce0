#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raycheck::tools {

/// What a program says, however much: its beginning and its end are kept.
class KeptText {
 public:
  void append(std::string_view more);
  bool empty() const { return begin_.empty(); }
  /// The beginning and the end, with a line between them that says how much is left out.
  std::string text() const;
  /// Its first and last lines, so many of each, and what is left out between them; without what a
  /// terminal would obey.
  std::string excerpt() const;

 private:
  std::string begin_, end_;
  std::size_t lines_ = 0;    ///< Ends of lines, of all that was said.
  std::size_t dropped_ = 0;  ///< Bytes.
};

}  // namespace raycheck::tools
