#pragma once

// Finds out from the answers which formula loses digits. Internal to answer_explanation.

#include <optional>

#include "properties/mistakes/answer_examination.h"

namespace raycheck::properties {

/// The roundings that explain the wrong answers at kIntersect or kNearest; empty if none do.
std::optional<AnswerCause> roundings_at(Examination& examination, Step step, double tolerance);

/// The cause of the errors of hits that are right up to kAnswerTolerances; empty if it is not
/// found.
std::optional<AnswerCause> lost_digits(Examination& examination);
/// The cause of the errors of directions that are right up to kAnswerTolerances; empty if it is not
/// found.
std::optional<AnswerCause> lost_digits_of_rays(Examination& examination);

}  // namespace raycheck::properties
