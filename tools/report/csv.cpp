#include "tools/report/csv.h"

#include <algorithm>
#include <array>

#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::tools {
namespace {

/// Also as East Asian input methods write them, which spreadsheets take, too.
constexpr std::array<std::string_view, 11> kFormulasBegin = {
    "=", "+", "-", "@", "\t", "\r", "\n", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};

/// What tables write where there is no number.
constexpr std::string_view kNone = "-";

bool is_formula(std::string_view text) {
  return text != kNone && !scene::parse_number(text) &&
         std::any_of(kFormulasBegin.begin(), kFormulasBegin.end(),
                     [&](std::string_view sign) { return text.starts_with(sign); });
}

}  // namespace

std::string csv_cell(std::string_view text) {
  const bool is_defused = is_formula(text);
  const std::string cell = (is_defused ? "'" : "") + scene::visible(text);
  const bool is_plain = !is_defused && cell.find_first_of(",;\"\n\t") == std::string::npos &&
                        !cell.starts_with(' ') && !cell.ends_with(' ');
  if (is_plain) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace raycheck::tools
