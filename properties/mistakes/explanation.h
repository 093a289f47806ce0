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
  /// For answers, not pictures: the mistakes made together.
  std::vector<const Mistake*> mistakes = {};
};

/// A cause of wrong answers that other causes need not explain.
inline constexpr std::string_view kNotNumbers = "the answer is NaN or infinite";
/// The sentence if no mistake is named; `explained` is 0.
inline constexpr std::string_view kTooFewErrors = "too few wrong answers to name a cause";
/// Fewer wrong answers than this fit too many explanations. A mistake is then named only if no
/// other explains them, and if it gives the numbers of one of these answers.
inline constexpr std::uint64_t kFewestErrorsOfACause = 3;
/// If more mistakes than this explain the same answers, none is named.
inline constexpr std::size_t kMostAlternatives = 3;

/// The cause of a wrong answer if the candidate, restarted, answers the same question right.
inline constexpr std::string_view kKeepsState =
    "a question that is asked first is answered right: the candidate keeps state between questions";

/// An explanation must explain at least this share of the errors; a right answer that it
/// contradicts counts as an unexplained error.
inline constexpr double kExplainedShare = 0.9;

/// The most errors, of these, that an explanation may leave unexplained.
constexpr std::uint64_t most_unexplained(std::uint64_t errors) {
  return static_cast<std::uint64_t>(static_cast<double>(errors) * (1 - kExplainedShare));
}

}  // namespace raycheck::properties
