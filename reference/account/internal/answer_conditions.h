#pragma once

// The conditions under which an answer is right, and where they hold to first order. Internal to
// reference/.

#include <functional>
#include <optional>
#include <vector>

#include "reference/account/internal/answer_box.h"

namespace raycheck::reference {

/// `zero`, if given, is 0, and `sign` times `what` is not negative; or, if `sign` is 0, `what` is
/// as small as near a double root.
struct Condition {
  std::optional<Decider> zero;
  Decider what;
  int sign = 1;
};

/// The ways in which an answer may be right: each a list of conditions that hold at once.
std::vector<std::vector<Condition>> alternatives(const AnswerBox& box);

/// Whether one of the conditions certainly holds nowhere.
bool are_refuted(AnswerBox& box, const std::vector<Condition>& all);

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
