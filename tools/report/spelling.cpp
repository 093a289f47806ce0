#include "tools/report/spelling.h"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <utility>

#include "scene/number.h"
#include "scene/text.h"

namespace raycheck::tools {

namespace {

/// The characters that begin a formula, with their East Asian full-width forms, which spreadsheets
/// accept, too.
constexpr std::array<std::string_view, 11> kFormulasBegin = {
    "=", "+", "-", "@", "\t", "\r", "\n", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};

/// The text in tables if there is no value.
constexpr std::string_view kNone = "-";

bool is_formula(std::string_view text) {
  return text != kNone && !scene::parse_number(text) &&
         std::ranges::any_of(kFormulasBegin,
                             [&](std::string_view sign) { return text.starts_with(sign); });
}

}  // namespace

std::string csv_cell(std::string_view text) {
  const bool is_defused = is_formula(text);
  std::string cell = (is_defused ? "'" : "") + scene::visible(text);
  const bool is_plain = !is_defused && cell.find_first_of(",;\"\n\t") == std::string::npos &&
                        !cell.starts_with(' ') && !cell.ends_with(' ');
  if (is_plain) return cell;
  boost::replace_all(cell, "\"", "\"\"");
  return '"' + cell + '"';
}

std::string escaped(std::string_view text) {
  std::string result = scene::visible(text);
  for (const auto& [sign, name] :
       {std::pair("&", "&amp;"), std::pair("<", "&lt;"), std::pair(">", "&gt;"),
        std::pair("\"", "&quot;"), std::pair("'", "&#39;")}) {
    boost::replace_all(result, sign, name);
  }
  return result;
}

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // OpenSSL adds a NUL
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                  reinterpret_cast<const unsigned char*>(bytes.data()),
                  static_cast<int>(bytes.size()));
  text.pop_back();
  return text;
}

std::string data_address(std::string_view type, std::string_view bytes) {
  return fmt::format("data:{};base64,{}", type, base64(bytes));
}

}  // namespace raycheck::tools
