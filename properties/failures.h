#pragma once

// What a candidate's functions throw besides std::invalid_argument, which refuses input.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace raycheck::properties {

/// It would fail whatever it is asked.
class CandidateUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A line of a candidate's own source.
struct CodeLine {
  std::string file;       ///< Relative to the working folder where it lies below that.
  std::int64_t line = 1;  ///< From 1 on.
  std::string text = {};  ///< What stands there, without the space around it.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(file, line, text);
  }
};

/// It failed at a known line.
struct FailedAtLine : std::runtime_error {
  FailedAtLine(const std::string& what, CodeLine at)
      : std::runtime_error(what), line(std::move(at)) {}
  CodeLine line;
};

/// It gave no reply in time.
struct NoReply : std::runtime_error {
  NoReply(const std::string& what, std::optional<CodeLine> at)
      : std::runtime_error(what), line(std::move(at)) {}
  std::optional<CodeLine> line;
};

/// Its `image` made a picture of another size than the scene's.
struct OtherSize : std::runtime_error {
  OtherSize(const std::string& what, std::int64_t its_width, std::int64_t its_height)
      : std::runtime_error(what), width(its_width), height(its_height) {}
  std::int64_t width, height;
};

}  // namespace raycheck::properties
