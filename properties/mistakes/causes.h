#pragma once

#include <cstdint>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/mistakes/explanation.h"

namespace raycheck::properties {

/// How many cases of a broken law are searched for its cause, at most, and the most pixels that
/// their pictures may have.
inline constexpr std::size_t kCasesOfACause = 12;
inline constexpr std::int64_t kMostPixelsOfACause = std::int64_t{1} << 16;
/// Fewer wrong answers than this fit too many explanations to name a mistake.
inline constexpr std::uint64_t kFewestErrorsOfACause = 3;

/// The classic mistakes that explain a candidate's answers to cases, of which some are wrong.
std::vector<Explanation> causes(const std::vector<Case>& cases, const Candidate& candidate);

}  // namespace raycheck::properties
