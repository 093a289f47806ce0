#pragma once

#include <raycheck/judge.h>

#include "properties/candidate.h"
#include "properties/case.h"

namespace raycheck::library {

/// A candidate that laws can be asked about, held to the bounds of direct/cross. It is valid while
/// `candidate` is.
properties::Candidate inside(const Candidate& candidate);

/// Errors: std::invalid_argument where the scene is not valid or a pixel lies outside its image.
properties::Case case_of(const Case& the_case);
Case case_of(const properties::Case& the_case);

}  // namespace raycheck::library
