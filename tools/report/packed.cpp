#include "tools/report/packed.h"

#include <zlib.h>

#include <stdexcept>

namespace raycheck::tools {
namespace {

/// The size of zlib's window.
constexpr std::size_t kWindow = 1 << 15;
/// A deflated byte expands to at most this many bytes.
constexpr std::size_t kMostGrowth = 1032;

const Bytef* bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

}  // namespace

std::string packed(std::string_view text, Packing level, std::string_view before) {
  z_stream stream{};
  if (deflateInit(&stream, static_cast<int>(level)) != Z_OK) {
    throw std::runtime_error("zlib: out of memory");
  }
  if (before.size() > kWindow) before.remove_prefix(before.size() - kWindow);
  if (!before.empty()) {
    deflateSetDictionary(&stream, bytes_of(before), static_cast<uInt>(before.size()));
  }
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  stream.next_in = const_cast<Bytef*>(bytes_of(text));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

std::string unpacked(const std::string& bytes, std::size_t size) {
  if (size > kMostGrowth * (bytes.size() + 1)) return "";
  std::string text(size, '\0');
  uLongf made = size;
  const int result =
      uncompress(reinterpret_cast<Bytef*>(text.data()), &made, bytes_of(bytes), bytes.size());
  return result == Z_OK && made == size ? text : "";
}

}  // namespace raycheck::tools
