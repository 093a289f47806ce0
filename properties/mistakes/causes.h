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

/// How many cases of a broken law are searched for its cause, at most, and the most pixels that
/// their pictures may have.
inline constexpr std::size_t kCasesOfACause = 12;
inline constexpr std::int64_t kMostPixelsOfACause = std::int64_t{1} << 16;

/// Why a candidate breaks a law on some of these cases: it is right under conventions that it does
/// not declare (right_under), or the classic mistakes that explain its answers.
std::vector<Explanation> causes(const Law& law, const std::vector<Case>& cases,
                                const Candidate& candidate);

/// Cases of a law, in rounds that are searched until they tell a cause; empty: there are no more.
using TellingCases = std::function<std::vector<Case>(std::size_t round)>;
/// The same of these cases. Rounds after the second are searched only if all that these tell is
/// that answers are no numbers.
std::vector<Explanation> causes(const Law& law, const TellingCases& telling,
                                const Candidate& candidate);

}  // namespace raycheck::properties
