#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raycheck::tools {

/// zlib's levels.
enum class Packing { kQuickly = 1, kSmall = 9 };

/// The text compressed by zlib (RFC 1950), as a continuation of `before`.
std::string packed(std::string_view text, Packing level = Packing::kQuickly,
                   std::string_view before = {});
/// The text, of this size; empty if zlib finds the bytes invalid.
std::string unpacked(const std::string& bytes, std::size_t size);

}  // namespace raycheck::tools
