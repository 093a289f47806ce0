#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "properties/case.h"
#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "properties/quantity.h"
#include "properties/run_control.h"

namespace raycheck::properties {

/// The case for one stage. For intersections, the rays that `rays` makes from the camera replace it
/// and are taken as exact. Empty if no ray is left.
std::optional<Case> case_of_stage(const Case& the_case, Stage stage, const Candidate& rays);
/// The case for one stage in a format: the case is rounded to the format first, and so are the rays
/// that `rays` makes.
RoundedCase case_of_stage(const Case& the_case, Stage stage, const Candidate& rays,
                          InputFormat format);

/// A discrepancy and the case that shows it.
struct Example {
  Case the_case;
  Discrepancy discrepancy;
  void serialize(auto& archive) { archive(the_case, discrepancy); }
};

/// The verdicts on one candidate, on cases inside and outside its stated domain.
struct StressResult {
  Verdict inside;
  Verdict outside;
  std::vector<Example> found;  ///< The first example of each law and kind of error.
  std::uint64_t left_out = 0;  ///< Cases that its format cannot hold (rounded_case).

  void merge(StressResult other);
  void serialize(auto& archive) { archive(inside, outside, found, left_out); }
};

/// The answers that a candidate failed to give: their number, and the first failure's message.
struct AnswersFailed {
  std::uint64_t count = 0;
  std::string first = {};
};
AnswersFailed answers_failed(const StressResult& result);

struct StressOptions {
  int first = 0;  ///< The first case of the seed to run.
  int cases = 1000;
  std::uint64_t seed = 1;
};

/// Judges candidates on the same random cases of a source, rounded to the format of each candidate.
/// Every error is weighed by its condition number. If the stage needs given rays, the first
/// candidate of each format makes them from cameras; if that one makes no rays, the first of all
/// candidates does. The same options give the same result.
std::vector<StressResult> stress(const ChosenSource& source, Stage stage,
                                 std::span<const Candidate> candidates,
                                 const StressOptions& options, const RunControl& control = {});
/// Judges candidates on a given case, and adds the verdicts to `results`, one for each candidate.
void stress(const Case& the_case, Stage stage, std::span<const Candidate> candidates,
            std::vector<StressResult>& results);

/// The number of decisions that are wrong without an excuse.
std::uint64_t defects(const Verdict& verdict);
/// The largest stability ratio of a verdict; empty if nothing was measured.
std::optional<double> worst_ratio(const Verdict& verdict);
/// Whether there is no defect, and no stability ratio above kStableRatio.
bool is_stable(const Verdict& verdict);

/// The slope of the line that best fits log10(error) against log10(base^severity), over the
/// severities where the error grows: up to the first error that is at least a tenth of the largest
/// (an error stops growing when no digit is right any more), or over all severities if the errors
/// do not grow tenfold. Ignores errors that are 0 or not finite; empty if fewer than three remain.
/// Shape: one error per severity.
std::optional<double> error_slope(int base, std::span<const int> severities,
                                  std::span<const double> errors);

}  // namespace raycheck::properties
