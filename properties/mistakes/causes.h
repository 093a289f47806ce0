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

/// The most cases of a broken law that are searched for its cause, and the most pixels that their
/// pictures may have.
inline constexpr std::size_t kCasesOfACause = 12;
inline constexpr std::int64_t kMostPixelsOfACause = std::int64_t{1} << 16;

/// Why a candidate breaks a law on some of these cases: it is right under conventions that it does
/// not declare (right_under), or the classic mistakes that explain its answers.
std::vector<Explanation> causes(const Law& law, const std::vector<Case>& cases,
                                const Candidate& candidate);

/// Cases of a law, in rounds that are searched until a cause is found; empty after the last.
using TellingCases = std::function<std::vector<Case>(std::size_t round)>;
/// Why a candidate breaks a law on these cases. Rounds after the second are searched only if the
/// first two find nothing but answers that are not numbers.
std::vector<Explanation> causes(const Law& law, const TellingCases& telling,
                                const Candidate& candidate);

}  // namespace raycheck::properties
