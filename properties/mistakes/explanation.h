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
  std::vector<const Mistake*> mistakes = {};  ///< Of answers: those that are made together.
};

/// Of answers: a separate defect, which other causes need not explain.
inline constexpr std::string_view kNotNumbers = "not a number, or infinite";
/// In place of a mistake; `explained` is 0.
inline constexpr std::string_view kTooFewErrors = "too few wrong answers to tell why";
/// Fewer wrong answers than this fit too many explanations. Even so a mistake is named if it is the
/// only one, and gives the numbers of one of these answers.
inline constexpr std::uint64_t kFewestErrorsOfACause = 3;
/// The most mistakes that are named if they explain the same; of more, none is named.
inline constexpr std::size_t kMostAlternatives = 3;

/// The cause of wrong answers that are right if the same question comes first.
inline constexpr std::string_view kKeepsState =
    "answers differently, and correctly, when it is asked first: it keeps state between questions";

/// The least share of the errors that an explanation must explain; a right answer that it
/// contradicts counts as an unexplained error.
inline constexpr double kExplainedShare = 0.9;

/// The most of these errors that an explanation may leave unexplained.
constexpr std::uint64_t most_unexplained(std::uint64_t errors) {
  return static_cast<std::uint64_t>(static_cast<double>(errors) * (1 - kExplainedShare));
}

}  // namespace raycheck::properties
