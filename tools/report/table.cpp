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

Table::Table(const std::vector<std::string>& headings) {
  for (const std::string& heading : headings) {
    are_right_.push_back(heading.starts_with('>'));
    headings_.push_back(heading.substr(are_right_.back() ? 1 : 0));
  }
}

std::string Table::text(std::string_view indent) const {
  std::vector<std::size_t> widths(headings_.size());
  const auto widen = [&](const std::vector<std::string>& row) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  };
  widen(headings_);
  for (const auto& row : rows_) widen(row);
  std::string result;
  const auto print = [&](const std::vector<std::string>& row) {
    std::string printed = line(row, indent, "  ", "", [&](std::size_t k, const std::string& cell) {
      return are_right_[k] ? fmt::format("{:>{}}", cell, widths[k])
                           : fmt::format("{:<{}}", cell, widths[k]);
    });
    printed.erase(printed.find_last_not_of(' ') + 1);
    result += printed + "\n";
  };
  print(headings_);
  for (const auto& row : rows_) print(row);
  return result;
}

std::string Table::markdown() const {
  const auto as_is = [](std::size_t, const std::string& cell) { return cell; };
  const auto rule = [&](std::size_t k, const std::string&) {
    return are_right_[k] ? "---:" : "---";
  };
  std::string result =
      line(headings_, "| ", " | ", " |\n", as_is) + line(headings_, "|", "|", "|\n", rule);
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
