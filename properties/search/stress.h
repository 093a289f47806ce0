#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "properties/rounded_case.h"
#include "properties/run_control.h"
#include "properties/stage.h"

namespace raycheck::properties {

/// The laws that tell whether a stage is stable.
std::vector<const Law*> laws_of(Stage stage);

/// The case that asks a stage alone: for intersections the rays that `rays` makes of the case's
/// camera, taken exactly, in place of the camera. Empty where there is nothing to ask.
std::optional<Case> alone(const Case& the_case, Stage stage, const Candidate& rays);
/// The same in a format: of the case rounded to it, and where `rays` made numbers that are none of
/// it, those rounded, too.
RoundedCase alone(const Case& the_case, Stage stage, const Candidate& rays,
                  scene::Precision precision);

/// A discrepancy and the case that shows it.
struct Example {
  Case the_case;
  Discrepancy discrepancy;
};

/// What the same cases showed of one candidate, by whether they lie in its stated domain.
struct StressResult {
  Verdict inside;
  Verdict outside;
  std::vector<Example> found;  ///< The first of each law and kind of error.
  std::uint64_t left_out = 0;  ///< Cases that its format cannot hold (properties/rounded_case.h).

  void merge(StressResult other);
};

struct StressOptions {
  int cases = 1000;
  std::uint64_t seed = 1;
};

/// Judges candidates on the same random cases of a source at one severity (which a source without a
/// dial ignores), rounded to the format of each, every error weighed by its condition number.
/// Cameras' rays, where the stage is given rays, are made by the first candidate of a format, or
/// the first of all where that makes none. The same options give the same result.
std::vector<StressResult> stress(const CaseSource& source, int severity, Stage stage,
                                 std::span<const Candidate> candidates,
                                 const StressOptions& options, const RunControl& control = {});
/// The same on given cases: what they show of each candidate is added to `results`, one each.
void stress(const Case& the_case, Stage stage, std::span<const Candidate> candidates,
            std::vector<StressResult>& results);

/// Decisions that are wrong without an excuse.
std::uint64_t defects(const Verdict& verdict);
/// The largest stability ratio of a verdict; empty where nothing was measured.
std::optional<double> worst_ratio(const Verdict& verdict);
/// No defect, and no stability ratio above kStableRatio.
bool is_stable(const Verdict& verdict);

/// The slope of the line that fits log10(error) against log10(base^severity) best, while the error
/// still grows: up to the first that is at least a tenth of the largest (it stops growing when no
/// digit is right any more), or over all where none grows tenfold. Errors that are 0 or not finite
/// are left out; empty for fewer than three others.
/// Shape: one error a severity.
std::optional<double> error_slope(int base, std::span<const int> severities,
                                  std::span<const double> errors);

}  // namespace raycheck::properties
