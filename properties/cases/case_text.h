#pragma once

#include <string>
#include <string_view>

#include "properties/case.h"

namespace raycheck::properties {

/// A case as a TOML scene that `raycheck check` accepts; its pixels are listed in a comment.
std::string scene_text(const Case& the_case, std::string_view comment = {});

}  // namespace raycheck::properties
