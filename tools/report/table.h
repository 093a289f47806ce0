#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

/// How a report with tables is written.
enum class Markup { kPlain, kMarkdown };

/// A table of a report, printed as aligned text or as Markdown.
class Table {
 public:
  enum class Align { kLeft, kRight };
  struct Column {
    std::string heading;
    Align align = Align::kLeft;
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}
  /// One cell per column.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.empty(); }

  /// Lines indented by `indent`, columns two spaces apart.
  std::string text(std::string_view indent = "  ") const;
  std::string markdown() const;
  /// Under a heading, with empty lines around it.
  std::string section(std::string_view heading, Markup markup) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace raycheck::tools
