#include "scene/files/driver_entries.h"

#include <algorithm>
#include <utility>

#include "scene/interruption.h"

namespace raycheck::scene {
namespace {

constexpr std::string_view kSpace = " \t\v\f";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

std::string DriverEntry::joined() const {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::vector<DriverEntry> driver_entries(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<DriverEntry> entries;
  for (std::size_t line = 1; !text.empty(); ++line) {
    poll();
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view rest = text.substr(0, length);
    rest = rest.substr(0, rest.find('#'));
    const std::size_t line_end = text.substr(length).starts_with("\r\n") ? 2 : 1;
    text.remove_prefix(std::min(length + line_end, text.size()));
    DriverEntry entry{"", {}, line};
    while (rest.find_first_not_of(kSpace) != std::string_view::npos) {
      rest.remove_prefix(rest.find_first_not_of(kSpace));
      const std::string_view word = rest.substr(0, rest.find_first_of(kSpace));
      rest.remove_prefix(word.size());
      if (entry.keyword.empty()) {
        entry.keyword = word;
      } else {
        entry.words.emplace_back(word);
      }
    }
    if (!entry.keyword.empty()) entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace raycheck::scene
