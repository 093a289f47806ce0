#ifndef RAYCHECK_TOOLS_PROPERTIES_PROPERTIES_VIEWS_H_
#define RAYCHECK_TOOLS_PROPERTIES_PROPERTIES_VIEWS_H_

// The views of `properties`, each in the file of its name.

#include "tools/properties/properties.h"
#include "tools/report/view.h"

namespace raycheck::tools {

std::string properties_text(const PropertiesReport& report, const ViewOptions& options);
std::string properties_json(const PropertiesReport& report, const ViewOptions& options);

inline constexpr View<PropertiesReport> kPropertiesViews[] = {
    {"text", properties_text},
    {"json", properties_json},
};

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_PROPERTIES_PROPERTIES_VIEWS_H_
