#include "scene/files/format_words.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "scene/files/located_fields.h"
#include "scene/interruption.h"

namespace raycheck::scene {

namespace {

/// Puts the row by which a block is known first: the keys of YAML may have any order.
void order_blocks(const FileFormat& format, std::vector<NestedRow>& rows) {
  const auto is_known_by = [&](const NestedRow& row) {
    return !row.words.empty() &&
           (row.words[0] == format.definition[0] ||
            std::ranges::any_of(format.statements, [&](const FormatStatement& one) {
              return !one.rows.empty() && one.rows[0][0].word == row.words[0];
            }));
  };
  for (auto first = rows.begin(); first != rows.end();) {
    const auto end = std::find_if(first + 1, rows.end(), std::mem_fn(&NestedRow::begins));
    const auto known = std::find_if(first, end, is_known_by);
    if (known != end && first->words.size() > 1) {  // outermost keys of a mapping are one word
      std::swap(first->begins, known->begins);
      std::rotate(first, known, known + 1);
    }
    first = end;
  }
}

}  // namespace

std::vector<Word> words_of(const FileFormat& format, std::string_view text) {
  const std::string separators = format.separators + " \t\v\f";
  std::vector<Word> words;
  for (std::size_t line = 1; !text.empty(); ++line) {
    poll();
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view rest = text.substr(0, length);
    const std::size_t line_end = text.substr(length).starts_with("\r\n") ? 2 : 1;
    text.remove_prefix(std::min(length + line_end, text.size()));
    if (!format.comments.empty()) rest = rest.substr(0, rest.find(format.comments));
    for (const std::string_view word : split_words(rest, separators)) words.push_back({word, line});
  }
  return words;
}

std::vector<NestedRow> defined_rows(const FileFormat& format, std::string_view text,
                                    std::string_view file) {
  auto rows = nested_rows(format.nesting, text, format.separators, file);
  if (format.nesting == Nesting::kIndentation) order_blocks(format, rows);
  std::map<std::string, std::vector<std::string>, std::less<>> meanings;
  for (const auto& [word, meaning] : format.synonyms) meanings[word] = {meaning};
  const auto [definition, value, mark, more] = format.definition;
  std::string name;      // that is being defined
  bool is_kept = false;  // as it was defined first
  std::size_t added = 0;
  constexpr std::size_t kMostAdded = 1'000'000;
  for (NestedRow& row : rows) {
    if (row.begins) name.clear();
    const bool is_first = row.begins && row.words.size() > 1 && row.words[0] == definition;
    const bool is_value =
        is_first || (!name.empty() && (row.words[0] == value || row.words[0] == more));
    std::vector<std::string> words;
    for (std::size_t k = is_first ? 2 : is_value ? 1 : 0; k < row.words.size(); ++k) {
      const auto known = meanings.find(row.words[k]);
      if (known == meanings.end()) {
        words.push_back(std::move(row.words[k]));
        continue;
      }
      added += known->second.size();
      if (added > kMostAdded) {
        LocatedFields(file).fail(row.line, row.words[k],
                                 "stands for too many words: definitions may add " +
                                     std::to_string(kMostAdded) + " to a file");
      }
      words.insert(words.end(), known->second.begin(), known->second.end());
    }
    if (is_first) {
      name = mark + row.words[1];
      is_kept = format.nesting == Nesting::kTags && meanings.contains(name);
      if (!is_kept) meanings[name].clear();
    }
    if (is_value && !is_kept) std::ranges::move(words, std::back_inserter(meanings[name]));
    row.words = name.empty() ? std::move(words) : std::vector<std::string>{};
  }
  return rows;
}

std::vector<Word> words_of(const std::vector<NestedRow>& rows) {
  std::vector<Word> words;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    bool begins = rows[row].begins;
    for (const std::string& word : rows[row].words) {
      words.push_back({word, rows[row].line, row, std::exchange(begins, false)});
    }
  }
  return words;
}

}  // namespace raycheck::scene
