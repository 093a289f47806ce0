#include <fmt/core.h>

#include <algorithm>

#include "tools/grade/pages/wording.h"
#include "tools/grade/results/result.h"

namespace raycheck::tools {

std::string line_text(const std::string& name) {
  std::string text = plain_text(name);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, '?');
  return text;
}

namespace {

/// What the dry run found out, a line each.
std::string notes_text(const SubmissionGrade& grade) {
  std::string text;
  for (const std::string& note : grade.notes) text += "  " + line_text(note) + "\n";
  return text;
}

}  // namespace

std::string submission_text(const std::vector<const Item*>& items, const SubmissionGrade& grade) {
  if (!could_be_judged(grade)) {
    const std::string score =
        grade.score > 0 ? score_text(grade) + of_points_text(grade) + ", " : "";
    return fmt::format("{}: {}could not be judged: {}\n{}", line_text(grade.name), score,
                       refusal_text(*grade.refused), notes_text(grade));
  }
  std::string text =
      line_text(grade.name) + ": " + score_text(grade) + of_points_text(grade) + "\n";
  const std::string mistake = mistake_text(grade);
  if (!mistake.empty()) text += "  " + mistake + "\n";
  std::size_t width = 0;
  for (const Item* item : items) width = std::max(width, item->name.size());
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const ItemGrade& item = grade.items[k];
    const std::string of =
        item.state == ItemState::kNotAsked
            ? ""
            : fmt::format(" of {}{}", points_text(items[k]->points), item.bonus ? " (bonus)" : "");
    text += fmt::format("  {:<{}}  {:>5}{}  {}\n", item.name, width,
                        item.state == ItemState::kNotAsked ? "-" : points_text(item.score), of,
                        state_text(item));
  }
  return text + notes_text(grade);
}

}  // namespace raycheck::tools
