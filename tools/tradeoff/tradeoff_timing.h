#pragma once

// Measures the times for `tradeoff`. Internal to tools/tradeoff/.

#include <vector>

#include "properties/trial.h"
#include "tools/tradeoff/tradeoff.h"

namespace raycheck::tools {

/// Times every method's calls on the items of the cases, one by one and in batches, taking turns in
/// every repetition, so that disturbances of the machine affect all of them. A batch is timed only
/// when its answers are those of single calls, bit for bit. Fills in `scalar`, `batch` and
/// `not_timed`. Items: rays and spheres of the cases for an intersection method, pixels for a ray
/// method; only those in the method's stated domain.
void time_intersections(const std::vector<properties::Case>& cases, std::vector<MethodCost>& costs);
void time_rays(const std::vector<properties::Case>& cases, std::vector<MethodCost>& costs);

}  // namespace raycheck::tools
