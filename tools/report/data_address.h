#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// Bytes in base64 (RFC 4648).
std::string base64(std::string_view bytes);

/// Bytes as an address that needs no file: "data:image/png;base64,..." (RFC 2397; base64 of RFC
/// 4648).
std::string data_address(std::string_view type, std::string_view bytes);

}  // namespace raycheck::tools
