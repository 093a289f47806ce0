#pragma once

#include <string>

#include "tools/view/document.h"

namespace raycheck::tools {

/// A page's contents in lines: its start, its findings, what was left out.
std::string view_text(const ViewDocument& document, const std::string& file, std::size_t bytes);

}  // namespace raycheck::tools
