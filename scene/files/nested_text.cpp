#include "scene/files/nested_text.h"

#include <algorithm>
#include <map>
#include <utility>

#include "scene/interruption.h"

namespace raycheck::scene {
namespace {

constexpr std::string_view kWhite = " \t\v\f\r\n";

class RowList {
 public:
  explicit RowList(std::string_view separators)
      : separators_(std::string(separators).append(kWhite)) {}

  /// Adds a name and its value, if it has one or begins a block. What comes later in columns behind
  /// this one is in the name, except in that of a block.
  void add(std::size_t column, std::string_view name, std::string_view value, std::size_t line,
           bool begins) {
    leave(column);
    auto words = split_words(value, separators_);
    if (begins || !words.empty()) {
      NestedRow& row = rows_.emplace_back();
      constexpr std::size_t kMost = 3;  // deeper names have no meaning
      for (std::size_t k = 0; k < std::min(names_.size(), kMost); ++k) {
        row.words.push_back(names_[k].second);
      }
      if (!name.empty()) row.words.emplace_back(name);
      row.words.insert(row.words.end(), words.begin(), words.end());
      row.line = line;
      row.begins = begins;
    }
    constexpr std::size_t kLongest = 60;
    if (!name.empty() && column > 1) names_.emplace_back(column, name.substr(0, kLongest));
  }
  /// Leaves the names in this column and behind it; whether none is left.
  bool leave(std::size_t column) {
    while (!names_.empty() && names_.back().first >= column) names_.pop_back();
    return names_.empty();
  }
  std::vector<NestedRow> take() { return std::move(rows_); }

 private:
  std::string separators_;
  std::vector<NestedRow> rows_;
  std::vector<std::pair<std::size_t, std::string>> names_;
};

bool is_white_at(std::string_view text, std::size_t at) {
  return at >= text.size() || kWhite.find(text[at]) != kWhite.npos;
}

void add_indented(RowList& rows, std::string_view text, std::string_view comments) {
  bool is_item = false;
  for (std::size_t line = 1, lines = 1; !text.empty(); line += lines, lines = 1) {
    poll();
    std::string one;
    for (std::ptrdiff_t open = 1; !text.empty() && open > 0; lines += open > 0 ? 1U : 0U) {
      const std::string_view whole = text.substr(0, std::min(text.find('\n'), text.size()));
      std::size_t mark = comments.empty() ? whole.npos : whole.find(comments);
      while (mark < whole.size() && mark > 0 && !is_white_at(whole, mark - 1)) {
        mark = whole.find(comments, mark + 1);
      }
      const std::string_view part = whole.substr(0, mark);
      open += std::ranges::count(part, '[') - std::ranges::count(part, ']');
      if (one.empty()) --open;
      one.append(part).append(" ");
      text.remove_prefix(std::min(whole.size() + 1, text.size()));
    }
    std::size_t column = std::min(one.find_first_not_of(kWhite), one.size());
    if (one.starts_with("---")) continue;
    while (column < one.size() && one[column] == '-' && is_white_at(one, column + 1)) {
      is_item = true;
      column = std::min(one.find_first_not_of(kWhite, column + 1), one.size());
    }
    if (column == one.size()) continue;
    const std::string_view rest = std::string_view(one).substr(column);
    std::size_t colon = rest.find(':');
    while (colon < rest.size() && !is_white_at(rest, colon + 1)) colon = rest.find(':', colon + 1);
    if (rest.front() == '[' || rest.front() == '{') colon = rest.npos;
    const bool begins = (std::exchange(is_item, false) || column == 0) && rows.leave(column);
    const bool has_name = colon != rest.npos;
    rows.add(column, has_name ? rest.substr(0, colon) : "",
             has_name ? rest.substr(colon + 1) : rest, line, begins);
  }
}

/// Takes the attributes of a tag from a text, up to the tag's end.
std::map<std::string, std::string_view> take_attributes(std::string_view& text) {
  std::map<std::string, std::string_view> all;
  while (text.remove_prefix(std::min(text.find_first_not_of(kWhite), text.size())),
         !text.empty() && text.front() != '>' && !text.starts_with("/>")) {
    const std::size_t end = std::min(text.find_first_of("= \t\r\n\"'/>", 1), text.size());
    const std::size_t quote = std::min(text.find_first_not_of("= \t\r\n", end), text.size());
    const bool has_value = quote < text.size() && (text[quote] == '"' || text[quote] == '\'');
    const std::size_t close = has_value ? text.find(text[quote], quote + 1) : end;
    if (has_value && close != text.npos) {
      all.emplace(text.substr(0, end), text.substr(quote + 1, close - quote - 1));
    }
    text.remove_prefix(close == text.npos ? text.size() : close + (has_value ? 1 : 0));
  }
  return all;
}

void add_element(RowList& rows, std::size_t depth, std::string_view tag, std::size_t line,
                 std::map<std::string, std::string_view> attributes) {
  const auto take = [&](const char* name, std::string_view otherwise) {
    const auto node = attributes.extract(name);
    return std::string(node.empty() ? otherwise : node.mapped()) + " ";
  };
  const std::string_view name =
      depth > 1 && attributes.contains("name") ? attributes.extract("name").mapped() : tag;
  const std::string own = take("type", "") + take("name", "") + take("value", "");
  rows.add(depth, name, own, line, depth == 1);
  if (attributes.contains("x") || attributes.contains("y") || attributes.contains("z")) {
    rows.add(depth, name, take("x", "0") + take("y", "0") + take("z", "0"), line, false);
  }
  for (const auto& [attribute, value] : attributes) {
    rows.add(depth, name, attribute + " " + std::string(value), line, false);
  }
}

void add_tagged(RowList& rows, std::string_view text) {
  std::size_t depth = 0, line = 1;
  const auto skip = [&](std::size_t count) {
    count = std::min(count, text.size());
    line += static_cast<std::size_t>(std::ranges::count(text.substr(0, count), '\n'));
    text.remove_prefix(count);
  };
  while (skip(text.find('<')), !text.empty()) {
    poll();
    const bool is_comment = text.starts_with("<!--");
    const std::string_view after = text.substr(1, 1);
    if (after == "!" || after == "?" || after == "/") {
      if (after == "/" && depth > 0) --depth;
      skip(text.find(is_comment ? "-->" : ">"));
      continue;
    }
    const std::size_t end = std::min(text.find_first_of("/> \t\r\n", 1), text.size());
    std::string_view rest = text.substr(end);
    auto attributes = take_attributes(rest);
    if (depth > 0) {
      add_element(rows, depth, text.substr(1, end - 1), line, std::move(attributes));
    }
    if (rest.starts_with('>')) ++depth;
    skip(text.size() - rest.size());
  }
}

}  // namespace

std::vector<NestedRow> nested_rows(Nesting nesting, std::string_view text,
                                   std::string_view separators, std::string_view comments) {
  RowList rows(separators);
  if (nesting == Nesting::kTags) add_tagged(rows, text);
  if (nesting == Nesting::kIndentation) add_indented(rows, text, comments);
  return rows.take();
}

std::vector<std::string_view> split_words(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(separators, at)) != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

}  // namespace raycheck::scene
