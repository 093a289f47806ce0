#include <fmt/core.h>

#include "tools/grade/views.h"
#include "tools/grade/wording.h"

namespace raycheck::tools {

/// A row a submission, a column an item.
std::string class_csv(const ClassGrade& graded) {
  const auto quoted = [](const std::string& text) {
    // What a spreadsheet would take for a formula is text.
    std::string result = text.find_first_of("=+-@") == 0 ? "'" + text : text;
    for (std::size_t at = 0; (at = result.find('"', at)) != std::string::npos; at += 2) {
      result.insert(at, 1, '"');
    }
    return '"' + result + '"';
  };
  std::string text = "submission,score,points";
  for (const Item& item : graded.rubric.items) text += "," + quoted(item.name);
  text += ",note\n";
  for (const SubmissionGrade& grade : graded.submissions) {
    text += fmt::format("{},{},{}", quoted(grade.name), points_text(grade.score),
                        points_text(grade.points));
    for (const ItemGrade& item : grade.items) {
      text += "," + (item.state == ItemState::kNotAsked ? "" : points_text(item.score));
    }
    const std::string note = grade.refused    ? grade.refused->why
                             : grade.finished ? mistake_text(grade)
                                              : "interrupted";
    text += "," + (note.empty() ? "" : quoted(note)) + "\n";
  }
  return text;
}

}  // namespace raycheck::tools
