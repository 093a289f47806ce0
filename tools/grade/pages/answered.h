#pragma once

#include <memory>

#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {

/// How pages call a submission to its student.
inline constexpr const char* kYours = "yours";

/// What a submission answered about a failing case, as a method that gives the same answers to the
/// same questions: nothing is run. It is held to what the item tolerates; null where no answers are
/// kept, or they are withheld.
std::shared_ptr<const Implementation> answered(const FailingCase& failing,
                                               const Tolerance& tolerance, const Layers& isolation);

}  // namespace raycheck::tools
