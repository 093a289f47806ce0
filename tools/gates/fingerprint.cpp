#include "tools/gates/fingerprint.h"

#include <fmt/core.h>

#include <cstdint>

namespace raycheck::tools {

/// FNV-1a, twice with different beginnings, for 128 bits. Source: Fowler, Noll, Vo.
std::string fingerprint(std::string_view text) {
  constexpr std::uint64_t kPrime = 0x100000001B3;
  const auto hash = [&](std::uint64_t value) {
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * kPrime;
    return value;
  };
  return fmt::format("{:016x}{:016x}", hash(0xCBF29CE484222325), hash(0x84222325CBF29CE4));
}

}  // namespace raycheck::tools
