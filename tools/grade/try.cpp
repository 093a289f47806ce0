#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "tools/grade/grade.h"
#include "tools/grade/pages/views.h"
#include "tools/report/words.h"

namespace raycheck::tools {

bool TryReport::holds() const {
  const auto& items = shown.submission.items;
  return could_be_judged(shown.submission) &&
         std::all_of(items.begin(), items.end(), [](const ItemGrade& item) {
           return item.state == ItemState::kHolds || item.state == ItemState::kNotAsked;
         });
}

TryReport try_submission(GradeOptions options, const properties::RunControl& control) {
  options.for_student = true;
  ClassGrade graded = grade(options, control);
  TryReport report;
  report.interrupted = graded.interrupted;
  report.rubric = std::make_shared<const Rubric>(std::move(graded.rubric));
  if (graded.submissions.empty()) return report;
  report.shown = student_grade(*report.rubric, graded.submissions.front(), HiddenBy::kUs);
  if (options.out.empty()) return report;
  report.folder = (std::filesystem::path(options.out) / graded.submissions.front().name).string();
  return report;
}

/// The lines that `grade` prints for one submission, then details of the items that fail.
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
    // For unanswered items the line says everything.
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
