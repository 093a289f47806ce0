#pragma once

// Reports a case on which an item fails. Internal to grading.

#include <functional>
#include <optional>

#include "properties/mistakes/fault.h"
#include "tools/grade/judging/item_trial.h"

namespace raycheck::tools {

/// The numbers of a discrepancy, without its law.
WrongAnswer wrong_answer(const properties::Discrepancy& discrepancy);

/// The simplest case found that fails as `first` does: by the same law, in the same quantity and
/// way, with the same message if the candidate failed entirely, and, for a renderer whose mistakes
/// are known (`fault`), with a picture that they make. Timeouts are not shrunk, since every case
/// tried might take as long.
properties::Case simplest(const FailedCase& first, const ItemExaminee& who,
                          const properties::Fault& fault, const std::function<bool()>& is_late);

/// The report on a case, `first` being how it first failed; empty if it does not break the law any
/// more.
std::optional<FailingCase> failing_case(const properties::Case& the_case, const FailedCase& first,
                                        const Examinee& examinee);

}  // namespace raycheck::tools
