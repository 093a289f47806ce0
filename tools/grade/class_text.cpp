#include <fmt/core.h>

#include <algorithm>

#include "tools/grade/views.h"
#include "tools/grade/wording.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// A name without what a terminal would obey.
std::string line_text(const std::string& name) {
  std::string text = plain_text(name);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, '?');
  return text;
}

/// A line a submission, and its mistake.
std::string submission_lines(const ClassGrade& graded) {
  std::size_t width = 0;
  for (const SubmissionGrade& grade : graded.submissions) {
    width = std::max(width, line_text(grade.name).size());
  }
  std::string text;
  for (const SubmissionGrade& grade : graded.submissions) {
    text += fmt::format("{:<{}}  {:>6} of {}", line_text(grade.name), width,
                        points_text(grade.score), points_text(grade.points));
    std::string failing;
    for (const ItemGrade& item : grade.items) {
      if (item.state == ItemState::kFails) failing += (failing.empty() ? "" : ", ") + item.name;
    }
    if (grade.refused) {
      text += "  " + grade.refused->why;
    } else if (!grade.finished) {
      text += "  not finished";
    } else if (!failing.empty()) {
      text += "  fails " + failing;
    }
    text += "\n";
    const std::string mistake = mistake_text(grade);
    if (!mistake.empty()) text += fmt::format("{:<{}}    {}\n", "", width, mistake);
  }
  return text;
}

/// A line an item, for who looks at one submission.
std::string item_lines(const Rubric& rubric, const SubmissionGrade& grade) {
  std::string text = fmt::format("{}: {} of {}\n", line_text(grade.name), points_text(grade.score),
                                 points_text(grade.points));
  if (grade.refused) return text + refusal_text(*grade.refused) + "\n";
  std::size_t width = 0;
  for (const Item& item : rubric.items) width = std::max(width, item.name.size());
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const ItemGrade& item = grade.items[k];
    const std::string of = item.state == ItemState::kNotAsked
                               ? ""
                               : fmt::format(" of {}{}", points_text(rubric.items[k].points),
                                             item.bonus ? " (bonus)" : "");
    text += fmt::format("  {:<{}}  {:>5}{}  {}\n", item.name, width,
                        item.state == ItemState::kNotAsked ? "-" : points_text(item.score), of,
                        state_text(item));
  }
  const std::string mistake = mistake_text(grade);
  if (!mistake.empty()) text += "  " + mistake + "\n";
  return text;
}

}  // namespace

/// The table that the command prints.
std::string class_text(const ClassGrade& graded) {
  std::string text = graded.rubric.title + "\n";
  const bool is_one = graded.submissions.size() == 1;
  text += is_one ? item_lines(graded.rubric, graded.submissions.front()) : submission_lines(graded);
  if (is_one && !graded.out.empty()) {
    text +=
        fmt::format("see {}/{}/report.html\n", graded.out, line_text(graded.submissions[0].name));
  }
  if (graded.interrupted) {
    text += "INTERRUPTED: the same command goes on where it was cut.\n";
  }
  text += count_text(graded.submissions.size(), "submission") + " graded";
  if (graded.reused > 0) text += fmt::format(", {} of them by an earlier run", graded.reused);
  return text + "\n";
}

}  // namespace raycheck::tools
