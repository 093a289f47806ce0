#pragma once

#include "tools/stress/stress.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// A family's dial as a page: the error of each method at every severity, and at some of them a
/// case as a scene, of the first ones that on which the first method is worst.
/// `is_of_methods`: panels show the steps of these methods alone.
/// Domain: options with one family; otherwise throws std::invalid_argument naming the field.
ViewDocument dial_document(const StressOptions& options, bool is_of_methods,
                           const properties::RunControl& control);

}  // namespace raycheck::tools
