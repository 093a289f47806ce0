#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tools/view/document.h"

namespace raycheck::tools {

/// A document as one self-contained HTML file. Its content security policy allows only its own
/// script and style, by their hashes, and embedded pictures.
std::string page(const ViewDocument& document);

/// The approximate number of bytes that `text` adds to a compressed stream after `before`.
std::size_t deflated_behind(std::string_view before, std::string_view text);

}  // namespace raycheck::tools
