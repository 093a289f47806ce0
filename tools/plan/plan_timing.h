#pragma once

#include "tools/plan/plan.h"

namespace raycheck::tools {

/// Fills in the times of a report whose scene and plan are there, and what decided the pixels
/// timed: the whole image where that is quick, otherwise bands (or rows) spread over it.
/// Errors: std::invalid_argument where the image is too large to be seen
/// (reference::kMostVisibleSide); scene::Interrupted, with what was timed until then.
void time_plan(PlanReport& report);

}  // namespace raycheck::tools
