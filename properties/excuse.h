#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "reference/account/nearby_answer.h"

namespace raycheck::properties {

/// The verdict on an answer that differs from the truth. Only a defect counts against the method;
/// only an excused answer counts as right.
enum class Standing {
  kDefect,
  kUndecided,  ///< Neither a witness was found nor a refutation.
  kExcused,
  kNotJudged,  ///< Outside the method's stated domain.
};
inline constexpr std::size_t kStandingCount = 4;
inline constexpr std::array<std::string_view, kStandingCount> kStandingNames = {
    "defect", "undecided", "excused", "not judged"};
constexpr std::string_view name(Standing standing) {
  return kStandingNames[static_cast<std::size_t>(standing)];
}

/// The standing of a wrong decision, by what a search among nearby inputs found.
constexpr Standing standing_of(reference::Nearby found) {
  switch (found) {
    case reference::Nearby::kWitness:
      return Standing::kExcused;
    case reference::Nearby::kRefuted:
      return Standing::kDefect;
    default:
      return Standing::kUndecided;
  }
}

enum class ExcuseKind {
  kNone,
  kUndecided,
  kWitness,
  kThreshold,
  kIllConditioned,
  kOutsideDomain,
};
inline constexpr std::array<std::string_view, 6> kExcuseNames = {
    "", "undecided", "witness", "threshold", "ill-conditioned", "outside the domain"};
constexpr std::string_view name(ExcuseKind kind) {
  return kExcuseNames[static_cast<std::size_t>(kind)];
}

/// Why a discrepancy is not held against the method, if anything.
struct Excuse {
  ExcuseKind kind = ExcuseKind::kNone;
  /// Depends on the kind: the relative change of the inputs within which a witness was found, or a
  /// refutation (kNone; 0 where no excuse applies), or neither; the threshold that the exact s does
  /// not exceed; the condition number that allows the error. 0 for other kinds.
  double amount = 0;
  /// The changed inputs for which the answer is right, if there is a witness.
  reference::InputChange witness = {};

  Standing standing() const {
    switch (kind) {
      case ExcuseKind::kNone:
        return Standing::kDefect;
      case ExcuseKind::kUndecided:
        return Standing::kUndecided;
      case ExcuseKind::kOutsideDomain:
        return Standing::kNotJudged;
      default:
        return Standing::kExcused;
    }
  }
  bool operator==(const Excuse&) const = default;
};

}  // namespace raycheck::properties
