#ifndef RAYCHECK_TOOLS_CHECK_CHECK_PAGE_H_
#define RAYCHECK_TOOLS_CHECK_CHECK_PAGE_H_

#include <vector>

#include "tools/check/check.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// The scene of a report as a page, with its worst discrepancies and largest errors beside it: one
/// view of it for raycheck's methods, and one for each implementation of someone else's. What is
/// wanted is shown first.
ViewDocument check_document(const CheckReport& report, const std::vector<Selection>& wanted,
                            const properties::RunControl& control);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_CHECK_CHECK_PAGE_H_
