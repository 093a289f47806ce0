#ifndef RAYCHECK_TOOLS_WORST_WORST_PAGE_H_
#define RAYCHECK_TOOLS_WORST_WORST_PAGE_H_

#include <string>

#include "tools/view/document.h"
#include "tools/worst/worst.h"

namespace raycheck::tools {

/// The input found, as a page.
/// Domain: something was measured.
ViewDocument worst_document(const WorstReport& report, const properties::RunControl& control);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_WORST_WORST_PAGE_H_
