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

/// The sentence for answers that are NaN or infinite: a separate defect, which other causes need
/// not explain.
inline constexpr std::string_view kNotNumbers = "not a number, or infinite";
/// The sentence if no mistake can be named; `explained` is 0.
inline constexpr std::string_view kTooFewErrors = "too few wrong answers to tell why";
/// Fewer wrong answers than this fit too many explanations. With fewer, a mistake is named only if
/// it is the only one that explains them and reproduces the numbers of at least one.
inline constexpr std::uint64_t kFewestErrorsOfACause = 3;
/// If more mistakes than this explain the same answers, none of them is named.
inline constexpr std::size_t kMostAlternatives = 3;

/// The sentence for wrong answers that are right if the same question comes first.
inline constexpr std::string_view kKeepsState =
    "answers differently, and correctly, when it is asked first: it keeps state between questions";

/// An explanation must explain at least this share of the errors; a right answer that it
/// contradicts counts as an unexplained error.
inline constexpr double kExplainedShare = 0.9;

/// The most errors, of these, that an explanation may leave unexplained.
constexpr std::uint64_t most_unexplained(std::uint64_t errors) {
  return static_cast<std::uint64_t>(static_cast<double>(errors) * (1 - kExplainedShare));
}

}  // namespace raycheck::properties
