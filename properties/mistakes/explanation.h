#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::properties {

struct Mistake;

/// A convention or classic mistakes that account for wrong answers.
struct Explanation {
  std::string sentence;  ///< "rows are upside down"
  std::uint64_t errors = 0, explained = 0;
  std::vector<const Mistake*> mistakes = {};  ///< Of answers: that are made together.
};

/// Of answers: a separate defect, which no other cause has to explain.
inline constexpr std::string_view kNotNumbers = "not a number, or infinite";
/// In place of a mistake; `explained` is 0.
inline constexpr std::string_view kTooFewErrors = "too few wrong answers to tell why";
/// Fewer wrong answers than this fit too many explanations. A mistake is named nevertheless if it
/// is the only one, and makes the numbers of one of them.
inline constexpr std::uint64_t kFewestErrorsOfACause = 3;
/// How many mistakes that explain the same are named, at most; of more none is.
inline constexpr std::size_t kMostAlternatives = 3;

/// Of wrong answers that are right where the same question is the first.
inline constexpr std::string_view kKeepsState =
    "answers differently, and correctly, when it is asked first: it keeps state between questions";

/// The least share of the errors that an explanation must explain; a right answer that it
/// contradicts counts as an unexplained error.
inline constexpr double kExplainedShare = 0.9;

/// How many of these errors an explanation may leave unexplained.
constexpr std::uint64_t most_unexplained(std::uint64_t errors) {
  return static_cast<std::uint64_t>(static_cast<double>(errors) * (1 - kExplainedShare));
}

}  // namespace raycheck::properties
