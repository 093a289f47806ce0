#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "tools/external/sandbox/process.h"

namespace raycheck::tools {
namespace {

/// Bytes kept of the beginning, and of the end.
constexpr std::size_t kKept = 16384;
constexpr std::size_t kLines = 12;
constexpr std::size_t kLongestLine = 400;

std::string printable(std::string line) {
  for (char& c : line) {
    if ((static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7f') c = '?';
  }
  if (line.size() <= kLongestLine) return line;
  // Do not cut within a multi-byte character.
  std::size_t end = kLongestLine;
  while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) --end;
  return line.substr(0, end) + " ...";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(printable(std::move(line)));
    at = end + 1;
  }
  return lines;
}

std::string left_out(std::size_t lines) {
  return fmt::format("... {} line{} left out ...\n", lines, lines == 1 ? "" : "s");
}

}  // namespace

void KeptText::append(std::string_view more) {
  lines_ += static_cast<std::size_t>(std::count(more.begin(), more.end(), '\n'));
  const std::size_t room = std::min(kKept - begin_.size(), more.size());
  begin_ += more.substr(0, room);
  end_ += more.substr(room);
  if (end_.size() > kKept) {
    dropped_ += end_.size() - kKept;
    end_.erase(0, end_.size() - kKept);
  }
}

std::string KeptText::text() const {
  if (dropped_ == 0) return begin_ + end_;
  return fmt::format("{}\n... {} bytes left out ...\n{}", begin_, dropped_, end_);
}

std::string KeptText::excerpt() const {
  std::vector<std::string> first = lines_of(dropped_ == 0 ? begin_ + end_ : begin_);
  std::vector<std::string> last;
  std::size_t count = first.size();
  if (dropped_ != 0) {
    last = lines_of(end_);
    // The line is cut where text is missing.
    first.pop_back();
    last.erase(last.begin());
    count = std::max(lines_ + 1, first.size() + last.size());
    if (!end_.empty() && end_.back() == '\n') --count;
  } else if (count > 2 * kLines) {
    last.assign(first.end() - kLines, first.end());
  }
  std::string text;
  if (!last.empty()) {
    first.resize(std::min(first.size(), kLines));
    last.erase(last.begin(),
               last.end() - static_cast<std::ptrdiff_t>(std::min(last.size(), kLines)));
  }
  for (const std::string& line : first) text += line + "\n";
  if (!last.empty()) text += left_out(count - first.size() - last.size());
  for (const std::string& line : last) text += line + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace raycheck::tools
