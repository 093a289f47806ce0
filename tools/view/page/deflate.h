#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raycheck::tools {

/// Compressed as zlib does (RFC 1950), as far as it can. Errors: std::runtime_error.
std::string deflated(std::string_view text);

/// How many bytes a text comes to behind another in one compressed stream, nearly.
std::size_t deflated_behind(std::string_view before, std::string_view text);

}  // namespace raycheck::tools
