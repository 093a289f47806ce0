#pragma once

#include "properties/candidate.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// The candidate held to what an item tolerates.
properties::Candidate tolerated(properties::Candidate candidate, const Tolerance& tolerance);

}  // namespace raycheck::tools
