#ifndef RAYCHECK_TOOLS_EXCHANGE_EXCHANGE_H_
#define RAYCHECK_TOOLS_EXCHANGE_EXCHANGE_H_

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>

#include "properties/cases/case_source.h"
#include "tools/check/check.h"

namespace raycheck::tools {

// Questions and answers one a line, for programs between `raycheck generate` and `raycheck verify`:
// docs/candidates.md has the format. A question's id names the case, so that verify makes it again.

/// The questions of a case: every ray with every sphere.
/// Domain: a source of given rays.
std::string questions(const properties::ChosenSource& source, std::uint64_t seed);

struct VerifyReport {
  std::uint64_t answers = 0, cases = 0;
  std::uint64_t cases_asked = 0;  ///< 0: it was not said how many.
  CandidateReport candidate;
  /// The id of each ray of the report, by its index.
  std::vector<std::string> ids;
  std::size_t top = 10;
};

/// Judges answers by the laws of single values.
/// Errors: std::invalid_argument naming the line that is no answer.
VerifyReport verify(std::istream& answers, std::optional<double> max_error, std::size_t top);

/// Whether cases that were asked have no answer at all.
inline bool is_short(const VerifyReport& report) { return report.cases < report.cases_asked; }

std::string verify_text(const VerifyReport& report, bool colours);
std::string verify_json(const VerifyReport& report);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXCHANGE_EXCHANGE_H_
