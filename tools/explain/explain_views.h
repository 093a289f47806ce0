#pragma once

// The views of `explain`, each in the file of its name.

#include "tools/explain/explain.h"
#include "tools/report/view.h"

namespace raycheck::tools {

std::string explain_text(const ExplainReport& report, const ViewOptions& options);
std::string explain_json(const ExplainReport& report, const ViewOptions& options);

/// What the text says of one method: "s = 6 (0x1.8p+2), off by 0.2 ulp".
std::string method_verdict(const MethodReport& method, const ExplainReport& report);
/// Of that what follows an answer, ", off by 0.2 ulp, a false hit (excused)"; of a method that
/// makes rays all of it. Domain: it did not fail.
std::string answer_remarks(const MethodReport& method);
/// What is added to the step at which a method goes wrong; mostly nothing.
std::string wrong_step_remark(const MethodReport& method, const ExplainReport& report);

inline constexpr View<ExplainReport> kExplainViews[] = {
    {"text", explain_text},
    {"json", explain_json},
};

}  // namespace raycheck::tools
