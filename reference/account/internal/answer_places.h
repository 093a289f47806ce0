#pragma once

// Where an answer may be right, to first order. Internal to reference/.

#include <functional>
#include <vector>

#include "reference/account/internal/answer_conditions.h"

namespace raycheck::reference {

/// How a decider varies, about one point or over the box.
using VariationOf = std::function<Variation(Decider)>;

/// Points of the box [-1, 1]^n where the conditions hold if they hold anywhere, up to what is not
/// linear.
std::vector<std::vector<double>> places(const AnswerBox& box, const std::vector<Condition>& all,
                                        const VariationOf& variation_of);

/// Moves one coordinate, the one that must move least, so that the decider is 0 up to its last
/// bits.
std::vector<double> on_zero(const AnswerBox& box, Decider decider, const Variation& variation,
                            std::vector<double> t);

}  // namespace raycheck::reference
