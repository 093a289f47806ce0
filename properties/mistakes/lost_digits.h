#pragma once

// What answers tell of the digits that a formula loses. Internal to answer_explanation.

#include <optional>

#include "properties/mistakes/answer_examination.h"

namespace raycheck::properties {

/// The roundings that explain the wrong answers at kIntersect or kNearest, if any do.
std::optional<AnswerCause> roundings_at(Examination& examination, Step step, double tolerance);

/// Of answers that are right up to kAnswerTolerances what their errors tell, if anything.
std::optional<AnswerCause> lost_digits(Examination& examination);
/// The same of directions.
std::optional<AnswerCause> lost_digits_of_rays(Examination& examination);

}  // namespace raycheck::properties
