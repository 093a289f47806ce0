#pragma once

#include <raycheck/judge.h>

#include "properties/candidate.h"
#include "properties/case.h"

namespace raycheck::library {

/// A candidate as the laws take it, held to the bounds of direct/cross. `candidate` must outlive
/// it.
properties::Candidate inside(const Candidate& candidate);

/// Errors: std::invalid_argument where the scene is not valid or a pixel lies outside its image.
properties::Case case_of(const Case& the_case);
Case case_of(const properties::Case& the_case);

}  // namespace raycheck::library
