#include "tools/report/digest.h"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace raycheck::tools {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> made{};
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), made.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("OpenSSL does not provide SHA-256");
  }
  return {made.begin(), made.begin() + size};
}

std::string digest(const std::vector<std::string>& texts) {
  std::string all, hexadecimal;
  for (const std::string& text : texts) all += std::to_string(text.size()) + ":" + text;
  for (const unsigned char byte : sha256(all)) hexadecimal += fmt::format("{:02x}", byte);
  return hexadecimal;
}

}  // namespace raycheck::tools
