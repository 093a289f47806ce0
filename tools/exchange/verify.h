#ifndef RAYCHECK_TOOLS_EXCHANGE_VERIFY_H_
#define RAYCHECK_TOOLS_EXCHANGE_VERIFY_H_

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "tools/check/check.h"

namespace raycheck::tools {

struct VerifyOptions {
  std::uint64_t cases = 0;  ///< How many had questions; 0: not known.
  std::optional<double> max_error;
  bool strict = false;  ///< What is excused or undecided fails, too.
  std::size_t top = 10;
};

struct VerifyReport {
  std::uint64_t answers = 0, cases = 0;
  std::uint64_t cases_asked = 0;  ///< How many had questions; 0: not known.
  CandidateReport candidate;
  /// The id of each ray of the report, by its index.
  std::vector<std::string> ids;
  std::size_t top = 10;
  bool strict = false;

  /// Whether cases have no answer at all.
  bool is_short() const { return cases < cases_asked; }
  bool holds() const { return candidate.verdict.holds(strict) && !is_short(); }
};

/// Judges the answers to questions (tools/exchange/generate.h) by the laws of single values.
/// Errors: std::invalid_argument naming the line that is no answer.
VerifyReport verify(std::istream& answers, const VerifyOptions& options);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXCHANGE_VERIFY_H_
