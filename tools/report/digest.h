#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

/// The 32 bytes of SHA-256.
std::string sha256(std::string_view bytes);
/// SHA-256 of a list of texts, in hexadecimal. Different lists never give the same bytes to the
/// hash.
std::string digest(const std::vector<std::string>& texts);

}  // namespace raycheck::tools
