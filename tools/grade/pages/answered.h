#pragma once

#include <memory>

#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {

/// What pages call the student's own submission.
inline constexpr const char* kYours = "yours";

/// A submission's answers about a failing case, as a method that repeats them: nothing is run. The
/// item's tolerance applies; null if no answers are kept, or they are withheld.
std::shared_ptr<const Implementation> answered(const FailingCase& failing,
                                               const Tolerance& tolerance, const Layers& isolation);

}  // namespace raycheck::tools
