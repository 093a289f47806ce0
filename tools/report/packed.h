#pragma once

#include <cstddef>
#include <string>

namespace raycheck::tools {

/// The text compressed by zlib at its fastest level.
std::string packed(const std::string& text);
/// The text, of this size; empty if zlib finds the bytes invalid.
std::string unpacked(const std::string& bytes, std::size_t size);

}  // namespace raycheck::tools
