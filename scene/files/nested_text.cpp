#include "scene/files/nested_text.h"

#include <algorithm>
#include <map>
#include <utility>

#include "scene/interruption.h"

namespace raycheck::scene {
namespace {

/// Deeper names, and the rests of longer ones, have no meaning.
constexpr std::size_t kMostNames = 3, kLongestName = 60;

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

class Rows {
 public:
  void add(std::string_view name, std::string_view value, std::size_t line) {
    NestedRow& row = rows_.emplace_back();
    for (std::size_t k = 0; k < std::min(names_.size(), kMostNames); ++k) {
      row.words += names_[k].second + " ";
    }
    row.words.append(name).append(" ").append(value);
    row.line = line;
    row.begins = std::exchange(begins_, false);
  }
  void begin() { begins_ = true; }
  bool is_outermost() const { return names_.empty(); }
  /// What follows is contained in this name, until a name with this column, or one before it.
  void enter(std::size_t column, std::string_view name) {
    names_.emplace_back(column, std::string(name.substr(0, kLongestName)));
  }
  void leave(std::size_t column) {
    while (!names_.empty() && names_.back().first >= column) names_.pop_back();
  }
  NestedRow& last() { return rows_.back(); }
  std::vector<NestedRow> take() { return std::move(rows_); }

 private:
  std::vector<NestedRow> rows_;
  std::vector<std::pair<std::size_t, std::string>> names_;
  bool begins_ = false;
};

/// A line without its comment.
std::string_view uncommented(std::string_view line, std::string_view mark) {
  for (std::size_t at = 0; !mark.empty() && (at = line.find(mark, at)) != line.npos; ++at) {
    if (at == 0 || kBlanks.find(line[at - 1]) != kBlanks.npos) return line.substr(0, at);
  }
  return line;
}

std::vector<NestedRow> indented(std::string_view text, std::string_view comments) {
  Rows rows;
  std::ptrdiff_t open = 0;  // brackets, over lines
  bool is_item = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    poll();
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = uncommented(text.substr(0, end), comments);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto count_open = [&](std::string_view value) {
      open += std::ranges::count(value, '[') - std::ranges::count(value, ']');
    };
    if (open > 0) {
      rows.last().words.append(" ").append(trimmed(line));
      count_open(line);
      continue;
    }
    std::size_t column = line.find_first_not_of(kBlanks);
    if (column == line.npos || line.starts_with("---")) continue;
    while (column < line.size() && line[column] == '-' &&
           (column + 1 == line.size() || kBlanks.find(line[column + 1]) != kBlanks.npos)) {
      is_item = true;
      column = std::min(line.find_first_not_of(kBlanks, column + 1), line.size());
    }
    const std::string_view rest = trimmed(line.substr(column));
    if (rest.empty()) continue;
    rows.leave(column);
    const bool is_block = rows.is_outermost() && (is_item || column == 0);
    is_item = false;
    if (is_block) rows.begin();
    std::size_t colon = std::min(rest.find(": "), rest.size());
    if (rest.ends_with(':')) colon = std::min(colon, rest.size() - 1);
    if (std::string_view("[{\"'").find(rest.front()) != std::string_view::npos) colon = rest.size();
    const std::string_view name = rest.substr(0, colon);
    const std::string_view value = trimmed(rest.substr(std::min(colon + 1, rest.size())));
    if (is_block || colon == rest.size() || !value.empty()) rows.add(name, value, number);
    count_open(rest);
    if (colon < rest.size() && value.empty()) rows.enter(column, name);
  }
  return rows.take();
}

/// Reads the attributes of a tag, up to its end; true if the element ends there.
bool read_attributes(std::string_view& text, std::map<std::string, std::string_view>& all) {
  while (!text.empty()) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    if (text.starts_with("/>")) return true;
    if (text.empty() || text.front() == '>') return false;
    const std::size_t end = std::min(text.find_first_of("= \t\r\n\"'/>", 1), text.size());
    const std::string_view name = text.substr(0, end);
    text.remove_prefix(end);
    const std::size_t quote = text.find_first_not_of("= \t\r\n");
    if (quote == text.npos || (text[quote] != '"' && text[quote] != '\'')) continue;
    const std::size_t close = std::min(text.find(text[quote], quote + 1), text.size());
    all.emplace(name, text.substr(quote + 1, close - quote - 1));
    text.remove_prefix(std::min(close + 1, text.size()));
  }
  return true;
}

void add_element(Rows& rows, std::size_t depth, std::string_view tag, std::size_t line,
                 std::map<std::string, std::string_view> attributes) {
  if (depth == 0) return;  // the root
  const auto take = [&](const char* name) {
    const auto node = attributes.extract(name);
    return node.empty() ? std::string_view{} : node.mapped();
  };
  std::string_view name = depth == 1 ? "" : take("name");
  if (name.empty()) name = tag;
  if (depth == 1) rows.begin();
  std::string own(take("value"));
  own.append(own.empty() ? "" : " ").append(take("type"));
  if (depth == 1 || !own.empty()) rows.add(name, own, line);
  std::string point;
  bool has_point = false;
  for (const char* const coordinate : {"x", "y", "z"}) {
    const std::string_view value = take(coordinate);
    has_point = has_point || !value.empty();
    point.append(value.empty() ? "0" : value).append(" ");
  }
  if (has_point) rows.add(name, point, line);
  for (const auto& [attribute, value] : attributes) {
    rows.add(name, attribute + " " + std::string(value), line);
  }
  if (depth > 1) rows.enter(depth, name);
}

std::vector<NestedRow> tagged(std::string_view text) {
  Rows rows;
  std::size_t depth = 0, line = 1;
  const auto skip = [&](std::size_t count) {
    count = std::min(count, text.size());
    line += static_cast<std::size_t>(std::ranges::count(text.substr(0, count), '\n'));
    text.remove_prefix(count);
  };
  const auto skip_past = [&](std::string_view mark) {
    const std::size_t at = text.find(mark);
    skip(at == text.npos ? at : at + mark.size());
  };
  while (skip(text.find('<')), !text.empty()) {
    poll();
    if (text.starts_with("<!--")) {
      skip_past("-->");
    } else if (text.starts_with("<?") || text.starts_with("<!")) {
      skip_past(">");
    } else if (text.starts_with("</")) {
      skip_past(">");
      depth -= depth > 0 ? 1 : 0;
    } else {
      const std::size_t end = std::min(text.find_first_of("/> \t\r\n", 1), text.size());
      std::string_view rest = text.substr(end);
      std::map<std::string, std::string_view> attributes;
      const bool is_whole = read_attributes(rest, attributes);
      rows.leave(depth);
      add_element(rows, depth, text.substr(1, end - 1), line, std::move(attributes));
      depth += is_whole ? 0 : 1;
      skip(text.size() - rest.size());
    }
  }
  return rows.take();
}

}  // namespace

std::vector<NestedRow> nested_rows(Nesting nesting, std::string_view text,
                                   std::string_view comments) {
  return nesting == Nesting::kTags ? tagged(text) : indented(text, comments);
}

}  // namespace raycheck::scene
