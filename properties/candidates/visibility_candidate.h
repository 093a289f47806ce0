#pragma once

#include <cstdint>

#include "properties/candidate.h"

namespace raycheck::properties {

/// It answers by whole rows: the law that asks it leaves out larger images.
inline constexpr std::int64_t kMostCertifiedPixelsAcross = 1 << 12;

/// Certified visibility (reference/visibility/visibility.h) as a candidate, `certified`, that only
/// sees: by a plan that does what `items` say. It promises every decision.
Candidate certified_candidate(const scene::PlanItems& items = {});

}  // namespace raycheck::properties
