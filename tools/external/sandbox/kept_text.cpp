#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "tools/external/sandbox/process.h"

namespace raycheck::tools {
namespace {

/// The number of bytes kept of the beginning, and of the end.
constexpr std::size_t kKept = 16384;
constexpr std::size_t kLines = 12;
constexpr std::size_t kLongestLine = 400;

/// Java reports the options that raycheck gives it (launch.cpp).
std::string without_notices(std::string text) {
  constexpr std::string_view kNotice = "Picked up JAVA_TOOL_OPTIONS: ";
  for (std::size_t at; (at = text.find(kNotice)) != std::string::npos;) {
    const std::size_t end = text.find('\n', at);
    text.erase(at, end == std::string::npos ? end : end + 1 - at);
  }
  return text;
}

std::string printable(std::string line) {
  for (char& c : line) {
    if ((static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7f') c = '?';
  }
  if (line.size() <= kLongestLine) return line;
  return std::string(cut_to(line, kLongestLine)) + " ...";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(printable(std::move(line)));
    at = end + 1;
  }
  return lines;
}

}  // namespace

std::string_view cut_to(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

void KeptText::append(std::string_view more) {
  lines_ += static_cast<std::size_t>(std::ranges::count(more, '\n'));
  const std::size_t room = std::min(kKept - begin_.size(), more.size());
  begin_ += more.substr(0, room);
  end_ += more.substr(room);
  if (end_.size() > kKept) {
    dropped_ += end_.size() - kKept;
    end_.erase(0, end_.size() - kKept);
  }
}

std::string KeptText::text() const {
  if (dropped_ == 0) return without_notices(begin_ + end_);
  return fmt::format("{}\n... {} bytes left out ...\n{}", without_notices(begin_), dropped_,
                     without_notices(end_));
}

std::string KeptText::excerpt() const {
  std::vector<std::string> first = lines_of(dropped_ == 0 ? text() : without_notices(begin_));
  std::vector<std::string> last = first;
  std::size_t count = first.size();
  if (dropped_ != 0) {
    last = lines_of(without_notices(end_));
    // The lines around the gap are incomplete.
    first.pop_back();
    last.erase(last.begin());
    count = lines_ + (end_.ends_with('\n') ? 0 : 1);
  } else if (count <= 2 * kLines) {
    return fmt::format("{}", fmt::join(first, "\n"));
  }
  first.resize(std::min(first.size(), kLines));
  last.erase(last.begin(), last.end() - static_cast<std::ptrdiff_t>(std::min(last.size(), kLines)));
  std::vector<std::string> shown = std::move(first);
  const std::size_t missing = count - shown.size() - last.size();
  shown.push_back(fmt::format("... {} line{} left out ...", missing, missing == 1 ? "" : "s"));
  shown.insert(shown.end(), last.begin(), last.end());
  return fmt::format("{}", fmt::join(shown, "\n"));
}

}  // namespace raycheck::tools
