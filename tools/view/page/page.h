#pragma once

#include <string>

#include "tools/view/document.h"

namespace raycheck::tools {

/// A document as one self-contained HTML file. Its content security policy allows only its own
/// script and style, by their hashes, and embedded pictures.
std::string page(const ViewDocument& document);

}  // namespace raycheck::tools
