// Notebooks as modules of Python.

#include <cctype>
#include <sstream>
#include <vector>

#include "tools/grade/intake/handed_in.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

/// A text, or a list of its lines.
std::string joined(const Json& source) {
  if (source.is_string()) return source.get<std::string>();
  std::string text;
  for (const Json& line : source) text += line.get<std::string>();
  return text;
}

/// Cell magics whose cell is still Python.
bool is_python_cell(const std::string& cell) {
  std::istringstream words(cell);
  std::string first;
  words >> first;
  return !first.starts_with("%%") || first == "%%time" || first == "%%timeit" ||
         first == "%%capture" || first == "%%prun";
}

/// `%matplotlib inline`, `!pip install`, `?help`; not the rest of a formula.
bool is_magic(std::string_view line) {
  const char next = line.size() > 1 ? line[1] : ' ';
  return (line[0] == '%' && (next == '%' || std::isalpha(static_cast<unsigned char>(next)) != 0)) ||
         (line[0] == '!' && next != '=') || line[0] == '?';
}

std::string without_magics(const std::string& cell) {
  std::istringstream lines(cell);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find_first_not_of(" \t");
    const bool drops = at != std::string::npos && is_magic(std::string_view(line).substr(at));
    text += (drops ? line.substr(0, at) + "pass" : line) + "\n";
  }
  return text;
}

}  // namespace

std::optional<std::string> notebook_module(std::string_view text) try {
  const Json notebook = Json::parse(text);
  std::string module;
  for (const Json& cell : notebook.at("cells")) {
    if (cell.at("cell_type") != "code") continue;
    const std::string code = joined(cell.at("source"));
    if (is_python_cell(code)) module += without_magics(code) + "\n";
  }
  return module;
} catch (const Json::exception&) {
  return {};
}

}  // namespace raycheck::tools
