#pragma once

#include <vector>

#include "tools/external/external_candidate.h"

namespace raycheck::tools {

/// Someone else's implementation as a method of each stage that it offers something of: rays, then
/// intersections.
/// Errors: CandidateError where it is of no stage: a renderer, or what makes no rays and intersects
///         nothing.
std::vector<StagedMethod> staged(const External& external);

}  // namespace raycheck::tools
