#ifndef RAYCHECK_TOOLS_EXPLAIN_EXPLAIN_VIEWS_H_
#define RAYCHECK_TOOLS_EXPLAIN_EXPLAIN_VIEWS_H_

// The views of `explain`, each in the file of its name.

#include "tools/explain/explain.h"
#include "tools/report/view.h"

namespace raycheck::tools {

std::string explain_text(const ExplainReport& report, const ViewOptions& options);
std::string explain_json(const ExplainReport& report, const ViewOptions& options);

inline constexpr View<ExplainReport> kExplainViews[] = {
    {"text", explain_text},
    {"json", explain_json},
};

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXPLAIN_EXPLAIN_VIEWS_H_
