#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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
  bool strict = false;  ///< What is excused or undecided fails, too.
  std::size_t top = 10;
};

/// More rays than any case has.
inline constexpr std::size_t kMostRays = std::size_t{1} << 32;

/// Longer than any answer.
inline constexpr std::size_t kMostLineBytes = std::size_t{1} << 16;

struct VerifyReport {
  std::uint64_t answers = 0, cases = 0;
  std::uint64_t cases_asked = 0;
  std::uint64_t cases_left_out = 0;  ///< That floats cannot hold: they ask nothing.
  std::string ends_before;          ///< The first question without an answer; empty: there is none.
  properties::ChosenSource source;  ///< As in the options.
  std::uint64_t seed = 0;
  /// In its verdict ray k of the n-th case, from 0 on, is ray n * kMostRays + k.
  CandidateReport candidate;
  std::size_t top = 10;
  bool strict = false;
  bool interrupted = false;

  std::size_t ray_in_case(std::size_t ray) const { return ray % kMostRays; }
  /// "SOURCE:SEED:RAY", which begins the ids of the questions about it.
  std::string ray_id(std::size_t ray) const;
  bool holds() const { return candidate.verdict.holds(strict) && ends_before.empty(); }
};

/// The next part of what is read; empty at the end.
using ReadMore = std::function<std::string()>;

/// Judges the answers to questions (generate.h), in their order, by the laws of
/// single values. A case is judged, and forgotten, once all its questions are answered. Errors:
/// std::invalid_argument naming the line that is no answer to the next question.
VerifyReport verify(const ReadMore& answers, const VerifyOptions& options,
                    const properties::RunControl& control = {});

std::string verify_text(const VerifyReport& report, const ViewOptions& options);
std::string verify_json(const VerifyReport& report, const ViewOptions& options);

inline constexpr View<VerifyReport> kVerifyViews[] = {
    {"text", verify_text},
    {"json", verify_json},
};

}  // namespace raycheck::tools
