#ifndef RAYCHECK_LAW_TESTS_H_
#define RAYCHECK_LAW_TESTS_H_

// Shared by the headers for test frameworks: one test for each law and source.

#include <raycheck/judge.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace raycheck {

/// The outcome of one test.
struct LawOutcome {
  bool passes = false;           ///< The test's result.
  bool says_too_little = false;  ///< It passes, but no case or too few cases were judged.
  std::string text;              ///< The text of the verdict.
};

/// The tests of a candidate: every law that applies to it, on every source.
class LawTests {
 public:
  /// The default number of cases for each law and source.
  static constexpr int kCases = 100;

  /// An invalid candidate has one test, which fails with the reason.
  explicit LawTests(Candidate candidate, JudgeOptions options = usual())
      : candidate_(std::move(candidate)), options_(options) {
    try {
      checks_ = raycheck::checks(candidate_);
      if (checks_.empty()) error_ = "candidate: no law applies to it";
    } catch (const std::invalid_argument& error) {
      error_ = error.what();
    }
    // Without any test, an invalid candidate would pass.
    if (!error_.empty()) checks_ = {{"candidate", "valid"}};
  }

  /// The law and the source of each test, in the order of reports.
  [[nodiscard]] const std::vector<Check>& checks() const { return checks_; }

  /// Judges the candidate. Domain: a check of checks().
  [[nodiscard]] LawOutcome run(const Check& check) const {
    if (!error_.empty()) return {false, false, error_};
    const Verdict verdict = judge(candidate_, check.law, check.source, options_);
    const bool says_too_little = verdict.finding != Finding::holds &&
                                 (verdict.passes() || verdict.finding == Finding::too_few_judged);
    return {verdict.passes() || says_too_little, says_too_little, verdict.text};
  }

 private:
  static JudgeOptions usual() {
    JudgeOptions options;
    options.cases = kCases;
    return options;
  }

  Candidate candidate_;
  JudgeOptions options_;
  std::vector<Check> checks_;
  std::string error_;  ///< Why the candidate cannot be tested; empty if it can.
};

}  // namespace raycheck

#endif  // RAYCHECK_LAW_TESTS_H_
