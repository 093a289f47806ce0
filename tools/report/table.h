#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

enum class Markup { kPlain, kMarkdown };

/// A table of a report, printed as aligned text or as Markdown.
class Table {
 public:
  /// A table with these headings. If a heading begins with ">", its column is aligned to the right.
  explicit Table(const std::vector<std::string>& headings);
  /// Adds a row with one cell per column.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.empty(); }

  /// The table as lines that begin with `indent`, with two spaces between columns.
  std::string text(std::string_view indent = "  ") const;
  std::string markdown() const;
  /// The table under a heading, with empty lines around it.
  std::string section(std::string_view heading, Markup markup) const;

 private:
  std::vector<std::string> headings_;
  std::vector<bool> are_right_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace raycheck::tools
