#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

/// SHA-256 of texts, in hexadecimal; no two lists of texts run together.
std::string digest(const std::vector<std::string>& texts);

/// The seed of a submission: HMAC-SHA-256 of its name under a secret, its first 64 bits. Whoever
/// does not know the secret cannot foresee it.
std::uint64_t secret_seed(std::string_view secret, std::string_view name);

}  // namespace raycheck::tools
