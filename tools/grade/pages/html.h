#pragma once

#include <string>
#include <string_view>

#include "tools/report/spelling.h"

namespace raycheck::tools {

/// A self-contained page, for narrow and wide screens.
std::string page(std::string_view title, std::string_view body);

/// A link that saves a text as a file.
std::string download(std::string_view file, std::string_view text);

}  // namespace raycheck::tools
