#include <algorithm>
#include <span>

#include "scene/files/format_reading.h"
#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::scene {

void FormatStatements::refuse(std::string_view keyword, std::size_t at) const {
  const auto refused = format_.refused.find(keyword);
  if (refused == format_.refused.end()) return;
  located_.fail(words_[at].line, keyword, "cannot be read: " + refused->second);
}
void FormatStatements::warn_unknown(std::size_t at) {
  if (unknown_ == nullptr) unknown_ = &words_[at];
  warn(at, "unknown keyword, ignored");
}

bool FormatStatements::has_first_words(const FormatStatement& statement, std::size_t at) const {
  for (const FormatPart& part : statement.parts) {
    if (part.word.empty()) return true;
    if (at == words_.size() || words_[at++].text != part.word) return false;
  }
  return false;
}
std::string FormatStatements::shown_part(const FormatPart& part) {
  return part.word.empty() ? "{" + part.slot + "}" : part.word;
}

std::size_t FormatStatements::next_line(std::size_t at) const {
  const std::size_t row = words_[at].row;
  while (at < words_.size() && words_[at].row == row) ++at;
  return at;
}

std::optional<Extent> FormatStatements::matched(const std::vector<FormatPart>& parts,
                                                std::size_t first) {
  given_.clear();
  numbers_ = 0;
  const std::size_t end = format_.by_lines ? next_line(first) : words_.size();
  std::size_t at = first, needed = first + 1;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto& [word, slot, written, count] = parts[k];
    if (!word.empty()) {
      if (at == end || words_[at].text != word) return {};
      if (format_.is_nested()) first = at;  // its name is in front of it
      ++at;
    } else if (slot == "*") {
      const std::string_view next = k + 1 < parts.size() ? std::string_view(parts[k + 1].word) : "";
      if (next.empty() && !format_.by_lines) continue;
      // The statement of the next sphere begins with the same word.
      while (at < end && (next.empty() || words_[at].text != next)) {
        if (!format_.by_lines && words_[at].text == parts.front().word) return {};
        ++at;
      }
    } else if (count == 0) {
      if (slot == kAxis && at < end) axis_ = &words_[at];
      at = std::min(at + 1, end);
    } else if (written == kOptional) {
      at = std::min(at + count, end);
    } else {
      Given& its = given_.add(slot);
      its.line = words_[first].line;
      its.statement = first;
      for (std::size_t n = 0; n < count; ++n, ++at, ++numbers_) {
        if (at == end) fail_short(parts, first);
        its.numbers[n] = number(slot, first, at);
      }
      needed = at;
    }
  }
  return Extent{at, needed};
}

double FormatStatements::number(std::string_view slot, std::size_t first, std::size_t at) const {
  const std::string_view text = words_[at].text;
  const auto fail = [&](std::string_view what) {
    const std::string index = std::to_string(at - first - 1);
    located_.fail(words_[at].line, std::string(words_[first].text) + "[" + index + "]", text, what);
  };
  const auto value = parse_number(text);
  if (is_pixels(slot) && !(parse_integer(text) && is_whole(*value))) {
    fail("is not a whole number of pixels");
  }
  if (!value) fail("is not a number");
  return *value;
}

void FormatStatements::fail_short(const std::vector<FormatPart>& parts, std::size_t first) const {
  if (!format_.by_lines) {
    located_.fail(words_[first].line, words_[first].text, "ends before all of its numbers");
  }
  std::size_t needs = 0;
  for (const FormatPart& part : parts) {
    if (part.written != kOptional) needs += part.numbers;
  }
  fail_at(first, "needs " + std::to_string(needs) +
                     (needs == 1 ? " number, has " : " numbers, has ") + std::to_string(numbers_));
}

void FormatStatements::fail_at(std::size_t first, std::string_view what) const {
  const auto& [keyword, line, row, begins] = words_[first];
  if (!format_.by_lines) located_.fail(line, keyword, what);
  located_.fail(line, keyword, rest_of_line(first), what);
}
void FormatStatements::fail_twice(std::size_t at, std::size_t line) const {
  fail_at(at, "is given twice, first on line " + std::to_string(line));
}
std::string FormatStatements::rest_of_line(std::size_t first) const {
  const std::span<const Word> words(words_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                                    words_.begin() + static_cast<std::ptrdiff_t>(next_line(first)));
  return joined(words, " ", &Word::text);
}

void FormatStatements::warn(std::size_t at, const std::string& what) {
  constexpr std::size_t kMostWarnings = 20;
  const auto& [keyword, line, row, begins] = words_[at];
  if (!warned_.emplace(keyword).second || warned_.size() > kMostWarnings) return;
  warnings_.push_back(
      located_.located(line, keyword, what + " (first on line " + std::to_string(line) + ")"));
}

}  // namespace raycheck::scene
