#pragma once

#include <array>
#include <string>
#include <string_view>

#include "scene/invalid_input.h"

namespace raycheck::tools {

/// The kinds of external candidates.
enum class CandidateKind {
  kLibrary,  ///< A shared library with functions of <raycheck/candidate.h>.
  /// A C++ file, a folder of C++ files, or one with a CMakeLists.txt: compiled to a library.
  kSource,
  kCommand,  ///< A program that speaks the protocol.
  kRenderer  ///< A finished renderer, started for every scene; {scene} and {image} stand for files.
};
inline constexpr std::array<std::string_view, 4> kCandidateKindNames = {"library", "source",
                                                                        "command", "renderer"};

/// An external candidate as written in `--candidate` and rubrics: "source:rays.cpp".
struct CandidateSpec {
  CandidateKind kind = CandidateKind::kLibrary;
  std::string what;  ///< A path, or the words that start a program.

  std::string text() const;
  bool is_words() const {
    return kind == CandidateKind::kCommand || kind == CandidateKind::kRenderer;
  }
};

/// Why an external candidate cannot be run, with the output of its compiler or of the program.
class CandidateError : public scene::InvalidInput {
 public:
  /// `whose`: the candidate's name for what(); may be empty.
  explicit CandidateError(const std::string& why, std::string output = {},
                          std::string_view whose = {});
  /// One line, without the candidate's name.
  const std::string& why() const { return why_; }
  /// The output of the compiler or the program; may be empty.
  const std::string& output() const { return output_; }

 private:
  std::string why_, output_;
};

/// Errors: CandidateError that lists the kinds.
CandidateSpec parse_candidate(const std::string& text);

}  // namespace raycheck::tools
