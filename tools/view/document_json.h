#pragma once

#include <string>

#include "tools/view/document.h"

namespace raycheck::tools {

/// The document that a page is made of, on one line or several (docs/json.md).
std::string document_json(const ViewDocument& document);
std::string document_line(const ViewDocument& document);

/// A panel as the document has it.
std::string panel_line(const Panel& panel);

}  // namespace raycheck::tools
