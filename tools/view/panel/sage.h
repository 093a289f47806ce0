#pragma once

#include <string>

#include "tools/explain/explain.h"

namespace raycheck::tools {

/// What SageMath computes the same steps from, exactly: the inputs as rationals, then the formulas
/// of docs/problem.md.
std::string sage_input(const ExplainReport& report);

}  // namespace raycheck::tools
