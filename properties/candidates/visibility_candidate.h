#pragma once

#include <cstdint>

#include "properties/candidate.h"

namespace raycheck::properties {

/// It computes whole rows: larger images are not given to it.
inline constexpr std::int64_t kMostCertifiedPixelsAcross = 1 << 12;

/// Certified visibility (reference/visibility/visibility.h) as a candidate, `certified`, with
/// `visible` alone: by a plan with these `items`. It promises every decision.
Candidate certified_candidate(const scene::PlanItems& items = {});

}  // namespace raycheck::properties
