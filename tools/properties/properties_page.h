#pragma once

#include <string>

#include "tools/properties/properties.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// The shrunk case of every broken law, as a page: a scene each.
ViewDocument properties_document(const PropertiesReport& report,
                                 const properties::RunControl& control);

}  // namespace raycheck::tools
