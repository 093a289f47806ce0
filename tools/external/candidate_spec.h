#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace raycheck::tools {

/// In which form someone else's implementation is given.
enum class CandidateKind {
  kLibrary,  ///< A shared library with functions of <raycheck/candidate.h>.
  kSource,   ///< A C++ file, a folder of them or with a CMakeLists.txt, to be compiled to one.
  kCommand,  ///< A program that speaks the protocol.
  kRenderer  ///< A finished renderer, started for every scene; {scene} and {image} are files.
};
inline constexpr std::array<std::string_view, 4> kCandidateKindNames = {"library", "source",
                                                                        "command", "renderer"};

/// Someone else's implementation as `--candidate` and rubrics name it: "source:rays.cpp".
struct CandidateSpec {
  CandidateKind kind = CandidateKind::kLibrary;
  std::string what;  ///< A path, or the words that start a program.

  std::string text() const;
  bool is_words() const {
    return kind == CandidateKind::kCommand || kind == CandidateKind::kRenderer;
  }
};

/// Why someone else's implementation cannot be run, and what its compiler or itself said of it.
class CandidateError : public std::invalid_argument {
 public:
  /// `whose`: the candidate, where what() is to name it.
  explicit CandidateError(const std::string& why, std::string said = {},
                          std::string_view whose = {});
  /// One line, without the candidate's name.
  const std::string& why() const { return why_; }
  /// Lines of others, or empty.
  const std::string& said() const { return said_; }

 private:
  std::string why_, said_;
};

/// Errors: CandidateError that lists the kinds.
CandidateSpec parse_candidate(const std::string& text);

}  // namespace raycheck::tools
