#pragma once

// The conditions under which an answer is right. Internal to reference/.

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

}  // namespace raycheck::reference
