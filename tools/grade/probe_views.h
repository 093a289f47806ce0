#ifndef RAYCHECK_TOOLS_GRADE_PROBE_VIEWS_H_
#define RAYCHECK_TOOLS_GRADE_PROBE_VIEWS_H_

#include <string>

#include "tools/grade/probe.h"
#include "tools/report/view.h"

namespace raycheck::tools {

std::string probe_text(const ProbeReport& report, const ViewOptions& options);
std::string probe_json(const ProbeReport& report, const ViewOptions& options);

inline constexpr View<ProbeReport> kProbeViews[] = {{"text", probe_text}, {"json", probe_json}};

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_PROBE_VIEWS_H_
