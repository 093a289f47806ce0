#pragma once

#include <string>
#include <vector>

namespace raycheck::tools {

/// SHA-256 of texts, in hexadecimal; different lists never hash the same bytes.
std::string digest(const std::vector<std::string>& texts);

}  // namespace raycheck::tools
