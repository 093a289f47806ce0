#ifndef RAYCHECK_TOOLS_GRADE_RESULTS_TOLERATED_H_
#define RAYCHECK_TOOLS_GRADE_RESULTS_TOLERATED_H_

#include "properties/candidate.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// The candidate held to what an item tolerates.
properties::Candidate tolerated(properties::Candidate candidate, const Tolerance& tolerance);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_RESULTS_TOLERATED_H_
