#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/laws/law.h"
#include "properties/mistakes/explanation.h"

namespace raycheck::properties {

/// At most this many cases of a broken law are searched for its cause, and only cases whose
/// pictures have at most this many pixels.
inline constexpr std::size_t kCasesOfACause = 12;
inline constexpr std::int64_t kMostPixelsOfACause = std::int64_t{1} << 16;

/// Why a candidate breaks a law on some of these cases: the undeclared conventions under which it
/// is right (right_under), or the classic mistakes that explain its answers.
std::vector<Explanation> causes(const Law& law, const std::vector<Case>& cases,
                                const Candidate& candidate);

/// Returns the cases of one round. Rounds are searched until a cause is found; no cases: the rounds
/// are over.
using TellingCases = std::function<std::vector<Case>(std::size_t round)>;
/// The causes on the cases of these rounds. Rounds after the second are searched only if the first
/// two find nothing but answers that are not numbers.
std::vector<Explanation> causes(const Law& law, const TellingCases& telling,
                                const Candidate& candidate);

}  // namespace raycheck::properties
