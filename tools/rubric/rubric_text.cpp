#include <fmt/core.h>

#include <algorithm>

#include "tools/report/words.h"
#include "tools/rubric/rubric.h"

namespace raycheck::tools {

std::string rubrics_text(const std::vector<ShippedRubric>& rubrics) {
  std::size_t width = 0;
  for (const ShippedRubric& one : rubrics) width = std::max(width, one.name.size());
  std::string text;
  for (const ShippedRubric& one : rubrics) {
    text +=
        fmt::format("{:<{}}  {}, {}\n", one.name, width, one.title, count_text(one.items, "item"));
  }
  return text + "`raycheck rubric NAME` prints one, with --out FOLDER copies it with its scenes.\n";
}

std::string copied_text(const CopiedRubric& copied) {
  return fmt::format("wrote {} and {}\n", copied.path, count_text(copied.scenes, "scene"));
}

}  // namespace raycheck::tools
