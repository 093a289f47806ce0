#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tools/external/pictures/renderer.h"

namespace raycheck::tools {

/// A picture as it is kept between runs, and read again; empty where a text is none.
std::string stored_text(const MadePicture& made);
std::optional<MadePicture> stored_picture(std::string_view text);

}  // namespace raycheck::tools
