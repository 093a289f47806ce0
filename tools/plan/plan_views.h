#pragma once

// The views of `plan`, each in the file of its name.

#include "tools/plan/plan.h"
#include "tools/report/view.h"

namespace raycheck::tools {

std::string plan_text(const PlanReport& report, const ViewOptions& options);
std::string plan_json(const PlanReport& report, const ViewOptions& options);

inline constexpr View<PlanReport> kPlanViews[] = {
    {"text", plan_text},
    {"json", plan_json},
};

}  // namespace raycheck::tools
