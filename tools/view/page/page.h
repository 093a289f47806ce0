#pragma once

#include <string>

#include "tools/view/document.h"

namespace raycheck::tools {

/// A document as one HTML file, which needs no other and no network: its content security policy
/// allows its own script and style by their hashes, and pictures that are in it.
std::string page(const ViewDocument& document);

}  // namespace raycheck::tools
