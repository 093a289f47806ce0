#pragma once

#include <vector>

#include "tools/check/check.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// What is asked of a page besides what a report has found.
struct CheckPageOptions {
  std::vector<Selection> wanted;  ///< Shown first.
  bool is_of_methods = false;     ///< Methods were asked for: panels show the steps of no others.
};

/// The scene of a report as a page, with its worst discrepancies and largest errors beside it: one
/// view of it for raycheck's methods, and one for each implementation of someone else's.
ViewDocument check_document(const CheckReport& report, const CheckPageOptions& options,
                            const properties::RunControl& control);

}  // namespace raycheck::tools
