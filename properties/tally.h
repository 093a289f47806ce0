#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "properties/decision.h"
#include "properties/excuse.h"
#include "properties/quantile_sketch.h"

namespace raycheck::properties {

/// The quality of an answer, given the conditioning of its question.
enum class Outcome {
  kExact,              ///< The double nearest to the truth, or the right decision.
  kAccurate,           ///< Off by no more than kAccurateError.
  kIllConditioned,     ///< Off by more, but kappa explains it.
  kUnstable,           ///< Off by more than kappa explains.
  kExcusedDecision,    ///< A witness shows that a small change of the inputs makes it right.
  kUndecidedDecision,  ///< Neither a witness nor a refutation was found.
  kWrongDecision,      ///< A defect: no small change of the inputs makes it right.
  kOutsideDomain,      ///< Off by more than kAccurateError, or wrong, outside the stated domain.
};
inline constexpr std::size_t kOutcomeCount = 8;
inline constexpr std::array<std::string_view, kOutcomeCount> kOutcomeNames = {
    "exact",
    "accurate",
    "ill-conditioned",
    "unstable",
    "wrong decision, excused",
    "wrong decision, undecided",
    "wrong decision",
    "outside the stated domain"};
constexpr auto& names_of(Outcome /*of*/) { return kOutcomeNames; }

/// Errors up to these, in the unit of their quantity (ulp or u) times the method's unit roundoff
/// over that of the format it is judged in, count as exact and as accurate.
inline constexpr double kExactError = 0.5;
inline constexpr double kAccurateError = 4;

/// A method is stable on a source of cases when its stability ratio rho = error / ((1 + kappa) u)
/// stays below this while the severity grows, and no decision is wrong without an excuse.
inline constexpr double kStableRatio = 16;

/// The error of an answer, relative to its conditioning.
struct Stability {
  double condition = 0;  ///< kappa
  /// rho; where kappa is infinite (an exact tangent) the backward error in units of u instead.
  double ratio = 0;
  Outcome outcome = Outcome::kExact;
};

/// The number of questions, and of answers that are right without an excuse.
struct Answered {
  std::uint64_t asked = 0;
  std::uint64_t right = 0;
  void merge(const Answered& other) {
    asked += other.asked;
    right += other.right;
  }
  void serialize(auto& archive) { archive(asked, right); }
};

/// Questions whose answers the smallest change of the inputs turns over, so that they are only
/// counted: exact tangents, where they count as hits; and hits at s = 0 that are missed.
enum class Fact { kTangent, kMissedAtZero };
inline constexpr std::size_t kFactCount = 2;

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
