#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "tools/external/sandbox/process.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/report/version.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// The folder of the shipped rubrics: beside the installed program, or in the sources.
fs::path shipped_folder() {
  fs::path installed = prefix() / "share/raycheck/rubrics";
  return fs::is_directory(installed) ? installed : fs::path(kSourceFolder) / "examples/rubrics";
}

std::optional<fs::path> if_file(const fs::path& path) {
  return fs::is_regular_file(path) ? std::optional(path) : std::nullopt;
}

}  // namespace

std::vector<std::string> shipped_rubrics() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(shipped_folder(), none)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::optional<fs::path> shipped_rubric(const fs::path& name) {
  if (name.has_parent_path()) return {};
  const fs::path path = shipped_folder() / name;
  return if_file(path.extension() == ".toml" ? path : fs::path(path.string() + ".toml"));
}

std::optional<fs::path> shipped_scene(const fs::path& name) {
  return if_file(shipped_folder() / name);
}

std::uint64_t secret_seed(std::string_view secret, std::string_view name) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned int size = 0;
  const auto* const text = reinterpret_cast<const unsigned char*>(name.data());
  if (HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()), text, name.size(),
           bytes.data(), &size) == nullptr) {
    throw std::runtime_error("HMAC-SHA-256 is not available");
  }
  std::uint64_t seed = 0;
  for (int k = 0; k < 8; ++k) seed = seed << 8 | bytes[static_cast<std::size_t>(k)];
  return seed;
}

}  // namespace raycheck::tools
