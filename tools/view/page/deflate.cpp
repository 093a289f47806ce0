#include <zlib.h>

#include <stdexcept>

#include "tools/view/page/page.h"

namespace raycheck::tools {
namespace {

/// zlib looks back so far.
constexpr std::size_t kWindow = 1 << 15;

const Bytef* bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

}  // namespace

std::string deflated(std::string_view text) {
  uLongf size = compressBound(text.size());
  std::string bytes(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, bytes_of(text), text.size(),
                Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib: the page cannot be compressed");
  }
  bytes.resize(size);
  return bytes;
}

std::size_t deflated_behind(std::string_view before, std::string_view text) {
  z_stream stream{};
  if (deflateInit(&stream, Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib: there is no room to compress in");
  }
  if (before.size() > kWindow) before.remove_prefix(before.size() - kWindow);
  deflateSetDictionary(&stream, bytes_of(before), static_cast<uInt>(before.size()));
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  stream.next_in = const_cast<Bytef*>(bytes_of(text));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  deflate(&stream, Z_FINISH);
  const std::size_t size = stream.total_out;
  deflateEnd(&stream);
  return size;
}

}  // namespace raycheck::tools
