#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace raycheck::properties {

struct Mistake;

/// A convention or a classic mistake that accounts for wrong answers.
struct Explanation {
  std::string sentence;  ///< "rows are upside down"
  std::uint64_t errors = 0, explained = 0;
  const Mistake* mistake = nullptr;  ///< Of answers, where it is one.
};

/// Of wrong answers that are right where the same question is the first.
inline constexpr std::string_view kKeepsState =
    "answers differently when asked first, and rightly: it keeps something between questions";

/// The least share of the errors that an explanation must explain; a right answer that it
/// contradicts counts as an unexplained error.
inline constexpr double kExplainedShare = 0.9;

/// How many of these errors an explanation may leave unexplained.
constexpr std::uint64_t most_unexplained(std::uint64_t errors) {
  return static_cast<std::uint64_t>(static_cast<double>(errors) * (1 - kExplainedShare));
}

}  // namespace raycheck::properties
