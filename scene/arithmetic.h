#pragma once

#include <string>

namespace raycheck::scene {

/// What keeps this thread's doubles from being those that every bound here takes for granted: they
/// round to nearest, keep subnormals, and have correctly rounded square roots and fused operations.
/// Empty where nothing does.
std::string arithmetic_defect();

}  // namespace raycheck::scene
