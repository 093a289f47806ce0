#pragma once

// Finds the digits that a formula loses from its answers. Internal to answer_explanation.

#include <optional>

#include "properties/mistakes/answer_examination.h"

namespace raycheck::properties {

/// The roundings that explain the wrong answers at kIntersect or kNearest, if there are such.
std::optional<AnswerCause> roundings_at(Examination& examination, Step step, double tolerance);

/// The cause of smaller errors of hits than kAnswerTolerances, if it is found.
std::optional<AnswerCause> lost_digits(Examination& examination);
/// The cause of smaller errors of directions than kAnswerTolerances, if it is found.
std::optional<AnswerCause> lost_digits_of_rays(Examination& examination);

}  // namespace raycheck::properties
