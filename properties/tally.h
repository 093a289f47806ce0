#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include "properties/decision.h"
#include "properties/excuse.h"
#include "properties/quantile_sketch.h"
#include "properties/stability.h"

namespace raycheck::properties {

/// The number of questions, and of answers that are right without an excuse.
struct Answered {
  std::uint64_t asked = 0;
  std::uint64_t right = 0;
  void serialize(auto& archive) { archive(asked, right); }
};

/// The comparisons of one quantity. The result does not depend on the order in which parts are
/// counted and merged; its memory does not grow with their number (properties/quantile_sketch.h).
struct Tally {
  std::uint64_t cases = 0;  ///< The right ones, the wrong ones and the errors.
  std::uint64_t right = 0;
  std::map<Wrong, std::uint64_t> wrong;
  std::array<std::uint64_t, kStandingCount> wrong_by_standing = {};
  std::array<Answered, kExpectedCount> answered = {};  ///< By Expected.
  QuantileSketch errors;                               ///< Empty for decisions.
  /// The least and the greatest bound that errors were compared with.
  double least_bound = std::numeric_limits<double>::infinity();
  double greatest_bound = -std::numeric_limits<double>::infinity();
  std::uint64_t ill_conditioned = 0;  ///< Above the flat bound, within its growth: no discrepancy.
  /// The largest error; for decisions 2 if one is a defect, 1 if all wrong ones are something else.
  double worst = -1;
  Place worst_place;  ///< The earliest of the worst.
  // Only for trials with TrialOptions::conditioning.
  QuantileSketch conditions;              ///< One for each error.
  std::optional<double> worst_condition;  ///< At worst_place.
  /// The largest stability ratio within the stated domain.
  std::optional<double> worst_ratio;
  std::array<std::uint64_t, kOutcomeCount> outcomes = {};
  /// The largest finite error over the growth of its documented bound, which limits this quotient.
  std::optional<double> max_over_growth;

  void merge(const Tally& other);
  /// Stores an error, or the rank of a wrong answer, if it is the worst.
  void note_worst(double badness, const Place& place, std::optional<double> condition = {});

  /// The bound that all errors were compared with; empty if bounds differ or there are no errors.
  std::optional<double> bound() const {
    return least_bound == greatest_bound ? std::optional(greatest_bound) : std::nullopt;
  }
  std::uint64_t wrong_answers() const;
  std::uint64_t count(Wrong kind) const;
  std::uint64_t count(Standing standing) const {
    return wrong_by_standing[static_cast<std::size_t>(standing)];
  }
  Answered& answers_to(Expected expected) { return answered[static_cast<std::size_t>(expected)]; }
  std::uint64_t count(Outcome outcome) const { return outcomes[static_cast<std::size_t>(outcome)]; }
  void serialize(auto& archive) {
    archive(cases, right, wrong, wrong_by_standing, answered, errors, least_bound, greatest_bound,
            ill_conditioned, worst, worst_place, conditions, worst_condition, worst_ratio, outcomes,
            max_over_growth);
  }
  /// Whether every error counted was weighed by its condition number.
  bool is_weighed() const { return errors.count() == conditions.count(); }
  /// Empty when no error was measured. The quantile is the least error that this share of all
  /// errors does not exceed, within kSketchResolution; the maximum is exact.
  std::optional<double> quantile(double share) const { return errors.quantile(share); }
  std::optional<double> median() const { return quantile(0.5); }
  std::optional<double> max() const { return errors.max(); }
  /// A quantile of the condition numbers.
  std::optional<double> condition_quantile(double share) const {
    return conditions.quantile(share);
  }
};

}  // namespace raycheck::properties
