#include "tools/report/packed.h"

#include <zlib.h>

#include <stdexcept>

namespace raycheck::tools {
namespace {

constexpr int kQuickly = 1;  ///< zlib's level
/// A deflated byte expands to at most this many bytes.
constexpr std::size_t kMostGrowth = 1032;

}  // namespace

std::string packed(const std::string& text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  const int result = compress2(reinterpret_cast<Bytef*>(bytes.data()), &size,
                               reinterpret_cast<const Bytef*>(text.data()), text.size(), kQuickly);
  if (result != Z_OK) throw std::runtime_error("zlib: out of memory");
  bytes.resize(size);
  return bytes;
}

std::string unpacked(const std::string& bytes, std::size_t size) {
  if (size > kMostGrowth * (bytes.size() + 1)) return "";
  std::string text(size, '\0');
  uLongf made = size;
  const int result = uncompress(reinterpret_cast<Bytef*>(text.data()), &made,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return result == Z_OK && made == size ? text : "";
}

}  // namespace raycheck::tools
