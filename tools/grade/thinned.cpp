#include <cctype>

#include "tools/grade/pages.h"
#include "tools/grade/words.h"

namespace raycheck::tools {

ItemGrade thinned(const Item& item, ItemGrade grade) {
  if (item.detail == Detail::kFull) return grade;
  grade.first_wrong.clear();
  if (item.detail == Detail::kNothing) {
    grade.failing.clear();
    grade.sentences.clear();
    return grade;
  }
  for (FailingCase& failing : grade.failing) failing.expected.clear();
  return grade;
}

std::string file_name(std::string_view item) {
  std::string name;
  for (const char c : item) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_plain) {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "item" : name;
}

}  // namespace raycheck::tools
