#include "tools/external/protocol/frames.h"

#include <charconv>

namespace raycheck::tools {
namespace {

/// The last complete line that begins with the word; empty if there is no such line.
std::string_view frames_line(std::string_view text) {
  std::string_view found;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    const std::string_view line = text.substr(0, end);
    if (line.starts_with(kFramesWord)) found = line.substr(kFramesWord.size());
    text.remove_prefix(end + 1);
  }
  return found;
}

}  // namespace

std::vector<std::uint64_t> frames_in(std::string_view text) {
  std::string_view rest = frames_line(text);
  std::vector<std::uint64_t> frames;
  while (!rest.empty()) {
    if (rest.front() != ' ' || frames.size() == kMostFrames) return {};
    rest.remove_prefix(1);
    std::uint64_t& frame = frames.emplace_back();
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), frame, 16);
    if (error != std::errc()) return {};
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  return frames;
}

}  // namespace raycheck::tools
