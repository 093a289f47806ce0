#pragma once

#include <cstdint>
#include <string>

namespace raycheck::properties {

struct Mistake;

/// One convention or one classic mistake that makes right what was wrong.
struct Explanation {
  std::string sentence;  ///< "rows are upside down"
  std::uint64_t errors = 0, explained = 0;
  const Mistake* mistake = nullptr;  ///< Of answers, where it is one.
};

/// The least share of the errors that is explained; a right answer that the explanation contradicts
/// counts against it as an error that it leaves.
inline constexpr double kExplainedShare = 0.9;

/// How many answers may be otherwise than an explanation says, of so many errors.
constexpr std::uint64_t most_unexplained(std::uint64_t errors) {
  return static_cast<std::uint64_t>(static_cast<double>(errors) * (1 - kExplainedShare));
}

}  // namespace raycheck::properties
