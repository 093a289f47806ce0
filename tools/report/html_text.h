#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// Text as HTML shows it, in elements and in attributes; what acts on what shows it is spelled
/// (scene/text.h).
std::string escaped(std::string_view text);

}  // namespace raycheck::tools
