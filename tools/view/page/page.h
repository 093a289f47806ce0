#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tools/view/document.h"

namespace raycheck::tools {

/// A document as one self-contained HTML file: its content security policy allows its own script
/// and style by their hashes, and embedded pictures.
std::string page(const ViewDocument& document);

/// The approximate number of bytes that a text adds after another in one compressed stream.
std::size_t deflated_behind(std::string_view before, std::string_view text);

}  // namespace raycheck::tools
