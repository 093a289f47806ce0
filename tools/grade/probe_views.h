#pragma once

#include <string>

#include "tools/grade/probe.h"
#include "tools/report/view.h"

namespace raycheck::tools {

std::string probe_text(const ProbeReport& report, const ViewOptions& options);
std::string probe_json(const ProbeReport& report, const ViewOptions& options);

inline constexpr View<ProbeReport> kProbeViews[] = {{"text", probe_text}, {"json", probe_json}};

}  // namespace raycheck::tools
