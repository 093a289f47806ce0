#ifndef RAYCHECK_TOOLS_TRY_TRY_VIEWS_H_
#define RAYCHECK_TOOLS_TRY_TRY_VIEWS_H_

#include <string>

#include "tools/try/try.h"

namespace raycheck::tools {

std::string try_text(const TryReport& report);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_TRY_TRY_VIEWS_H_
