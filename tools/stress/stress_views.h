#pragma once

// The views of `stress`, each in the file of its name.

#include "tools/report/view.h"
#include "tools/stress/stress.h"

namespace raycheck::tools {

std::string stress_text(const StressReport& report, const ViewOptions& options);
std::string stress_json(const StressReport& report, const ViewOptions& options);
std::string stress_csv(const StressReport& report, const ViewOptions& options);
std::string stress_markdown(const StressReport& report, const ViewOptions& options);

inline constexpr View<StressReport> kStressViews[] = {
    {"text", stress_text},
    {"json", stress_json},
    {"csv", stress_csv},
    {"markdown", stress_markdown},
};

/// Certificates of the first discrepancy of each kind at each severity: a line each.
std::string stress_certificates(const StressReport& report);

}  // namespace raycheck::tools
