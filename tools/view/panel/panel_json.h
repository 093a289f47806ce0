#pragma once

#include <string>

#include "tools/report/json.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// A number that is told, to 17 significant digits.
std::string digits_text(double value);

/// Of a ray and a sphere: the steps, what each method comes to, and the exact answer. A text that
/// is more than plain is a list of [kind, text]: "", "symbol", "number", "mark" (digits that are
/// wrong) or "wrong".
Json told_json(const ExplainReport& report);

Json microscope_json(const Microscope& microscope);

}  // namespace raycheck::tools
