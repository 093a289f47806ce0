#include <fmt/core.h>

#include "tools/grade/pages/wording.h"
#include "tools/report/words.h"
#include "tools/try/try_views.h"

namespace raycheck::tools {

/// The lines that `grade` prints of one submission, then what there is to say of items that fail.
std::string try_text(const TryReport& report) {
  const StudentGrade& shown = report.shown;
  std::string text = report.rubric->title + "\n" + submission_text(shown.items, shown.submission);
  if (shown.unlisted > 0) {
    text += fmt::format(
        "  {} in the score and not shown\n",
        shown.unlisted == 1 ? "1 item is" : fmt::format("{} items are", shown.unlisted));
  }
  for (std::size_t k = 0; k < shown.items.size(); ++k) {
    const ItemGrade& item = shown.submission.items[k];
    // Of what is not answered its line says all.
    const bool has_more = item.failing || item.reason.kind != ItemReason::Kind::kUnanswered;
    if (item.state != ItemState::kFails || !has_more) continue;
    text += "\n" + shown.items[k]->name + "\n" + indented(item_text(shown, k), "  ");
  }
  if (!report.folder.empty()) {
    text += "\nwritten: " + report.folder + "/report.html, and the smallest cases beside it\n";
  }
  if (report.interrupted) text += "INTERRUPTED: these are the items that were reached.\n";
  return text;
}

}  // namespace raycheck::tools
