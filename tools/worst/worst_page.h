#pragma once

#include <string>

#include "tools/view/document.h"
#include "tools/worst/worst.h"

namespace raycheck::tools {

/// The input found, as a page.
/// Domain: something was measured.
ViewDocument worst_document(const WorstReport& report, const properties::RunControl& control);

}  // namespace raycheck::tools
