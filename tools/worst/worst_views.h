#pragma once

// The views of `worst`, each in the file of its name.

#include "tools/report/view.h"
#include "tools/worst/worst.h"

namespace raycheck::tools {

std::string worst_text(const WorstReport& report, const ViewOptions& options);
std::string worst_json(const WorstReport& report, const ViewOptions& options);

inline constexpr View<WorstReport> kWorstViews[] = {
    {"text", worst_text},
    {"json", worst_json},
};

/// The input found as a TOML scene that says what is wrong on it.
/// Domain: something was measured.
std::string worst_scene(const WorstReport& report);

}  // namespace raycheck::tools
