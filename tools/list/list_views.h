#pragma once

// The views of `list`, each in the file of its name.

#include "tools/list/list.h"
#include "tools/report/view.h"

namespace raycheck::tools {

std::string list_text(const Catalogue& catalogue, const ViewOptions& options);
std::string list_json(const Catalogue& catalogue, const ViewOptions& options);

inline constexpr View<Catalogue> kListViews[] = {
    {"text", list_text},
    {"json", list_json},
};

}  // namespace raycheck::tools
