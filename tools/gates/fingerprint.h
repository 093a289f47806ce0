#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// Of a text, the same on every machine: 32 hexadecimal digits by which readers know a finding
/// again. Two texts have the same by accident alone; nothing is kept from who makes one.
std::string fingerprint(std::string_view text);

}  // namespace raycheck::tools
