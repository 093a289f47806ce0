#pragma once

#include <string>
#include <vector>

#include "tools/methods/methods.h"

namespace raycheck::tools {

/// What keeps those that are someone else's, and whose bounds they are held to, a line each, once.
std::string others_text(const std::vector<StagedMethod>& methods);

}  // namespace raycheck::tools
