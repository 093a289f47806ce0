#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "reference/account/nearby_answer.h"
#include "scene/conventions.h"

namespace raycheck::properties {

/// The verdict on an answer that differs from the truth. Only a defect counts against the
/// candidate; only an excused answer counts as right.
enum class Standing {
  kDefect,
  kUndecided,  ///< Neither a witness was found nor a refutation.
  kExcused,
  kNotJudged,  ///< Outside the method's stated domain.
};
inline constexpr std::size_t kStandingCount = 4;
inline constexpr std::array<std::string_view, kStandingCount> kStandingNames = {
    "defect", "undecided", "excused", "not judged"};
constexpr auto& names_of(Standing /*of*/) { return kStandingNames; }
using scene::name;

enum class ExcuseKind {
  kNone,
  kUndecided,
  kWitness,
  kThreshold,
  kIllConditioned,
  kOutsideDomain,
  kTolerance,
  kElsewhereInPixel,
};
/// A kind's name, and the standing that it gives an answer.
struct ExcuseInfo {
  std::string_view name;
  Standing standing;
};
inline constexpr std::array<ExcuseInfo, 8> kExcuses = {
    {{"", Standing::kDefect},
     {"undecided", Standing::kUndecided},
     {"witness", Standing::kExcused},
     {"threshold", Standing::kExcused},
     {"ill-conditioned", Standing::kExcused},
     {"outside the domain", Standing::kNotJudged},
     {"tolerance", Standing::kExcused},
     {"elsewhere in the pixel", Standing::kExcused}}};
constexpr const ExcuseInfo& info(ExcuseKind kind) {
  return kExcuses[static_cast<std::size_t>(kind)];
}
constexpr std::string_view name(ExcuseKind kind) { return info(kind).name; }

/// Why a discrepancy is not held against the candidate, if there is a reason.
struct Excuse {
  ExcuseKind kind = ExcuseKind::kNone;
  /// Depends on the kind: the relative change of the inputs within which a witness was found, or a
  /// refutation (kNone; 0 where no excuse applies), or neither; the threshold that the exact s does
  /// not exceed; the condition number that allows the error; the declared tolerance. 0 for
  /// other kinds.
  double amount = 0;
  /// The changed inputs for which the answer is right, if there is a witness.
  reference::InputChange witness = {};

  Standing standing() const { return info(kind).standing; }
  bool operator==(const Excuse&) const = default;
  void serialize(auto& archive) { archive(kind, amount, witness); }
};

}  // namespace raycheck::properties
