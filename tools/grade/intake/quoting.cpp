#include "tools/grade/intake/quoting.h"

#include "tools/report/words.h"

namespace raycheck::tools {

std::string shell_words(const std::vector<std::string>& names) {
  std::string words;
  for (const std::string& name : names) words += (words.empty() ? "" : " ") + single_quoted(name);
  return words;
}

std::string candidate_word(const std::string& name) {
  const char quote = name.find('"') == std::string::npos ? '"' : '\'';
  return name.find_first_of(" \t\"'") == std::string::npos ? name : quote + name + quote;
}

std::string with_mark(std::string text, std::string_view mark, const std::string& replacement) {
  for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos;
       at += replacement.size()) {
    text.replace(at, mark.size(), replacement);
  }
  return text;
}

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace raycheck::tools
