#pragma once

#include <string>

#include "tools/try/try.h"

namespace raycheck::tools {

std::string try_text(const TryReport& report);

}  // namespace raycheck::tools
