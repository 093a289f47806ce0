#pragma once

#include <cstddef>
#include <string>

namespace raycheck::tools {

/// Compressed by zlib, quickly.
std::string packed(const std::string& text);
/// The text of that size; empty if the bytes are invalid, by zlib's check.
std::string unpacked(const std::string& bytes, std::size_t size);

}  // namespace raycheck::tools
