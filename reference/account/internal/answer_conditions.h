#pragma once

// What must be so for an answer to be right. Internal to reference/.

#include <optional>
#include <vector>

#include "reference/account/internal/answer_box.h"

namespace raycheck::reference {

/// `zero`, where given, is 0, and `what` times `sign` is not negative; or, where the sign is 0,
/// `what` is as small as near a double root.
struct Condition {
  std::optional<Decider> zero;
  Decider what;
  int sign = 1;
};

/// The ways in which an answer may be right, each a list of what must be so at once.
std::vector<std::vector<Condition>> alternatives(const AnswerBox& box);

/// Whether one of the conditions is certainly met nowhere.
bool are_refuted(AnswerBox& box, const std::vector<Condition>& all);

}  // namespace raycheck::reference
