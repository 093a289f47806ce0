#pragma once

// The views of `verify`, each in the file of its name.

#include "tools/check/verify.h"
#include "tools/report/view.h"

namespace raycheck::tools {

std::string verify_text(const VerifyReport& report, const ViewOptions& options);
std::string verify_json(const VerifyReport& report, const ViewOptions& options);

inline constexpr View<VerifyReport> kVerifyViews[] = {
    {"text", verify_text},
    {"json", verify_json},
};

}  // namespace raycheck::tools
