#include "tools/report/table.h"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>

namespace raycheck::tools {
namespace {

template <class Cells, class Write>
std::string line(const Cells& cells, std::string_view before, std::string_view between,
                 std::string_view after, Write write) {
  std::string text(before);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k > 0) text += between;
    text += write(k, cells[k]);
  }
  return text + std::string(after);
}

}  // namespace

std::string Table::text(std::string_view indent) const {
  std::vector<std::string> headings;
  for (const Column& column : columns_) headings.push_back(column.heading);
  std::vector<std::size_t> widths(columns_.size());
  const auto widen = [&](const std::vector<std::string>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  };
  widen(headings);
  for (const auto& row : rows_) widen(row);
  std::string result;
  const auto print = [&](const std::vector<std::string>& row) {
    std::string printed = line(row, indent, "  ", "", [&](std::size_t k, const std::string& cell) {
      return columns_[k].align == Align::kRight ? fmt::format("{:>{}}", cell, widths[k])
                                                : fmt::format("{:<{}}", cell, widths[k]);
    });
    printed.erase(printed.find_last_not_of(' ') + 1);
    result += printed + "\n";
  };
  print(headings);
  for (const auto& row : rows_) print(row);
  return result;
}

std::string Table::markdown() const {
  std::string result = line(columns_, "| ", " | ", " |\n",
                            [](std::size_t, const Column& column) { return column.heading; });
  result += line(columns_, "|", "|", "|\n", [](std::size_t, const Column& column) {
    return std::string(column.align == Align::kRight ? "---:" : "---");
  });
  for (const auto& row : rows_) {
    result += line(row, "| ", " | ", " |\n", [](std::size_t, const std::string& cell) {
      return boost::replace_all_copy(cell, "|", "\\|");
    });
  }
  return result;
}

std::string Table::section(std::string_view heading, Markup markup) const {
  return markup == Markup::kPlain ? fmt::format("\n{}\n\n{}", heading, text())
                                  : fmt::format("\n### {}\n\n{}", heading, markdown());
}

}  // namespace raycheck::tools
