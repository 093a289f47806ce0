#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/cases/case_source.h"
#include "properties/run_control.h"
#include "tools/check/check.h"
#include "tools/report/view.h"

namespace raycheck::tools {

struct VerifyOptions {
  /// What generate was asked for: the cases are those of `cases` seeds from `seed` on.
  properties::ChosenSource source;
  std::uint64_t cases = 0;
  std::uint64_t seed = 0;
  scene::Precision precision = scene::Precision::kDouble;
  std::optional<double> max_error;
  bool strict = false;  ///< Excused or undecided answers fail, too.
  std::size_t top = 10;
};

/// How many questions without an answer are named.
inline constexpr std::size_t kNamedMissing = 5;

/// More than the rays of any case.
inline constexpr std::size_t kMostRays = std::size_t{1} << 32;

struct VerifyReport {
  VerifyOptions options;
  std::uint64_t answers = 0, cases = 0;
  std::uint64_t cases_left_out = 0;  ///< Floats cannot hold them: nothing is asked.
  std::uint64_t not_answered = 0;    ///< Questions of the cases that were looked at.
  std::vector<std::string> missing;  ///< The first of those.
  /// In its verdict ray k of the n-th case, from 0 on, is ray n * kMostRays + k.
  CandidateReport candidate;
  bool interrupted = false;

  std::size_t ray_in_case(std::size_t ray) const { return ray % kMostRays; }
  std::string case_id(std::uint64_t number) const;
  /// "SOURCE:SEED:RAY", the start of the ids of the questions about it.
  std::string ray_id(std::size_t ray) const;
  bool holds() const { return candidate.verdict.holds(options.strict) && not_answered == 0; }
};

/// Judges the answers to questions (generate.h), a line each, by the laws of single values.
/// Errors: std::invalid_argument naming the line that is no answer to a question asked, or is the
///         second to one.
VerifyReport verify(std::string text, const VerifyOptions& options,
                    const properties::RunControl& control = {});

std::string verify_text(const VerifyReport& report, const ViewOptions& options);
std::string verify_json(const VerifyReport& report, const ViewOptions& options);

inline constexpr View<VerifyReport> kVerifyViews[] = {
    {"text", verify_text},
    {"json", verify_json},
};

}  // namespace raycheck::tools
