#include <stdexcept>
#include <string>
#include <utility>

#include "tests/fuzz/targets.h"
#include "tools/exchange/verify.h"
#include "tools/external/protocol/protocol.h"
#include "tools/report/picture_reader.h"

namespace raycheck::tests {
namespace {

constexpr std::string_view kId = "7";
constexpr std::size_t kCount = 3;

template <class Read>
void try_to(const Read& read) {
  try {
    read();
  } catch (const tools::ProtocolError&) {
  }
}

}  // namespace

void fuzz_reply(std::string_view bytes) {
  try_to([&] { tools::parse_introduction(bytes); });
  std::size_t end = 0;
  while (end < bytes.size()) {
    const std::size_t next = bytes.find('\n', end);
    const std::string_view line = bytes.substr(end, next - end);
    end = next == std::string_view::npos ? bytes.size() : next + 1;
    if (tools::ends_reply(line, kId)) break;
  }
  try_to([&] {
    const tools::Reply reply(bytes.substr(0, end), kId);
    try_to([&] { reply.frame(); });
    try_to([&] { reply.points(kCount); });
    try_to([&] { reply.rays(kCount); });
    try_to([&] { reply.hits(kCount, kCount); });
    try_to([&] { reply.nearest(kCount, kCount); });
  });
}

void fuzz_picture(std::string_view bytes) {
  constexpr std::int64_t kMostPixels = 1 << 16;
  try {
    const tools::ReadPicture picture = tools::parse_picture(bytes, kMostPixels);
    const auto pixels = static_cast<std::size_t>(picture.width * picture.height);
    if (picture.pixels.size() != pixels) throw std::logic_error("pixels are missing");
  } catch (const tools::PictureError&) {
  }
}

void fuzz_verify(std::string_view bytes) {
  const tools::VerifyOptions options{
      .source = properties::chosen_source("tangency"), .cases = 5, .seed = 1, .max_error = {}};
  std::string left(bytes);
  try {
    tools::verify([&] { return std::exchange(left, ""); }, options);
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace raycheck::tests
