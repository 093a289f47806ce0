#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "scene/conventions.h"

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
using scene::name;

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

}  // namespace raycheck::properties
