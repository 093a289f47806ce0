#pragma once

#include <cstdint>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/mistakes/explanation.h"

namespace raycheck::properties {

/// At most so many cases of a broken law are looked at for its cause, pictures of at most so many
/// pixels each.
inline constexpr std::size_t kCasesOfACause = 12;
inline constexpr std::int64_t kMostPixelsOfACause = std::int64_t{1} << 16;
/// Fewer wrong answers are explained by too much to name a mistake.
inline constexpr std::uint64_t kFewestErrorsOfACause = 3;

/// The classic mistakes that explain what a candidate answers to cases, of which some are wrong.
std::vector<Explanation> causes(const std::vector<Case>& cases, const Candidate& candidate);

}  // namespace raycheck::properties
