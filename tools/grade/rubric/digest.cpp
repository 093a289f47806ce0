#include "tools/grade/rubric/digest.h"

#include <fmt/core.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <array>
#include <stdexcept>

namespace raycheck::tools {

std::string digest(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += std::to_string(text.size()) + ":" + text;
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned int size = 0;
  if (EVP_Digest(all.data(), all.size(), bytes.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 is not to be had");
  }
  std::string hexadecimal;
  for (unsigned int k = 0; k < size; ++k) hexadecimal += fmt::format("{:02x}", bytes[k]);
  return hexadecimal;
}

std::uint64_t secret_seed(std::string_view secret, std::string_view name) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned int size = 0;
  const auto* const text = reinterpret_cast<const unsigned char*>(name.data());
  if (HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()), text, name.size(),
           bytes.data(), &size) == nullptr) {
    throw std::runtime_error("HMAC is not to be had");
  }
  std::uint64_t seed = 0;
  for (int k = 0; k < 8; ++k) seed = seed << 8 | bytes[static_cast<std::size_t>(k)];
  return seed;
}

}  // namespace raycheck::tools
