#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace raycheck::properties {

/// A line of a candidate's own source.
struct CodeLine {
  std::string file;       ///< Relative to the working folder where it lies below that.
  std::int64_t line = 1;  ///< From 1 on.
  std::string text = {};  ///< What stands there, without the space around it.
};

/// Thrown by a candidate's function that failed at a known line.
class FailedAtLine : public std::runtime_error {
 public:
  FailedAtLine(const std::string& what, CodeLine line)
      : std::runtime_error(what), line_(std::move(line)) {}
  const CodeLine& line() const { return line_; }

 private:
  CodeLine line_;
};

}  // namespace raycheck::properties
