#include <algorithm>
#include <cctype>

#include "tools/grade/pages.h"
#include "tools/grade/words.h"

namespace raycheck::tools {

namespace {

/// File systems take 255 bytes at most.
constexpr std::size_t kLongestName = 80;

}  // namespace

ItemGrade thinned(const Rubric& rubric, const Item& item, ItemGrade grade) {
  if (grade.state == kLeftOut) {
    const bool tells_hidden =
        std::any_of(rubric.items.begin(), rubric.items.end(), [&](const Item& other) {
          return other.visibility != Visibility::kVisible &&
                 std::find(item.needs.begin(), item.needs.end(), other.name) != item.needs.end();
        });
    if (tells_hidden) grade.reason = "it needs other items";
  }
  if (item.detail == Detail::kFull) return grade;
  grade.first_wrong.clear();
  if (item.detail == Detail::kNothing) {
    grade.failing.clear();
    grade.sentences.clear();
    return grade;
  }
  for (FailingCase& failing : grade.failing) {
    failing.expected.clear();
    // By how much it is off tells the rest.
    failing.what.erase(std::min(failing.what.size(), failing.what.find(": off by ")));
  }
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
  name.resize(std::min(name.size(), kLongestName));
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "item" : name;
}

}  // namespace raycheck::tools
