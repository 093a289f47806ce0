#include <fmt/core.h>

#include "tools/grade/pages/views.h"
#include "tools/grade/pages/wording.h"
#include "tools/report/spelling.h"

namespace raycheck::tools {

namespace {

std::string csv_note(const SubmissionGrade& grade) {
  if (!could_be_judged(grade)) return csv_cell(not_judged_text(grade));
  if (!grade.finished) return "interrupted";
  const std::string time_up = time_up_text(grade), mistake = mistake_text(grade);
  const std::string note = time_up + (time_up.empty() || mistake.empty() ? "" : "; ") + mistake;
  return note.empty() ? "" : csv_cell(note);
}

}  // namespace

/// A row per submission, a column per item; without points if it could not be judged, except those
/// that the rubric gives for that.
std::string class_csv(const ClassGrade& graded) {
  std::string text = "submission,score,points";
  for (const Item& item : graded.rubric.items) text += "," + csv_cell(item.name);
  text += ",note\n";
  for (const SubmissionGrade& grade : graded.submissions) {
    const bool is_judged = could_be_judged(grade);
    const bool has_score = is_judged || grade.score > 0;
    text += fmt::format("{},{},{}", csv_cell(grade.name), has_score ? points_text(grade.score) : "",
                        points_text(grade.points));
    for (const ItemGrade& item : grade.items) {
      const bool has_points = is_judged && item.state != ItemState::kNotAsked;
      text += "," + (has_points ? points_text(item.score) : "");
    }
    text += "," + csv_note(grade) + "\n";
  }
  return text;
}

}  // namespace raycheck::tools
