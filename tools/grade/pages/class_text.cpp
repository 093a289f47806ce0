#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tools/grade/pages/views.h"
#include "tools/grade/pages/wording.h"
#include "tools/grade/results/statistics.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// A line per submission, and its mistake.
std::string submission_lines(const ClassGrade& graded) {
  std::size_t width = 0;
  for (const SubmissionGrade& grade : graded.submissions) {
    width = std::max(width, line_text(grade.name).size());
  }
  std::string text;
  for (const SubmissionGrade& grade : graded.submissions) {
    const bool is_judged = could_be_judged(grade);
    text += fmt::format("{:<{}}  {:>6}{}", line_text(grade.name), width, score_text(grade),
                        of_points_text(grade));
    std::string failing;
    for (const ItemGrade& item : grade.items) {
      if (item.state == ItemState::kFails) failing += (failing.empty() ? "" : ", ") + item.name;
    }
    if (!is_judged) {
      text += "  " + not_judged_text(grade);
    } else if (!grade.finished) {
      text += "  not finished";
    } else if (!failing.empty()) {
      text += "  fails " + failing;
    }
    text += "\n";
    const auto line = [&](const std::string& words) {
      if (!words.empty()) text += fmt::format("{:<{}}    {}\n", "", width, words);
    };
    if (is_judged) line(time_up_text(grade));
    line(mistake_text(grade));
    for (const std::string& note : grade.notes) line(line_text(note));
  }
  return text;
}

}  // namespace

/// The table that the command prints.
std::string class_text(const ClassGrade& graded) {
  std::string text = graded.rubric.title + "\n";
  if (graded.isolation) text += isolation_text(*graded.isolation) + "\n";
  std::vector<const Item*> items;
  for (const Item& item : graded.rubric.items) items.push_back(&item);
  const bool is_one = graded.submissions.size() == 1;
  text += is_one ? submission_text(items, graded.submissions.front()) : submission_lines(graded);
  if (is_one && !graded.out.empty()) {
    text +=
        fmt::format("see {}/{}/report.html\n", graded.out, line_text(graded.submissions[0].name));
  }
  if (graded.interrupted) {
    text += "INTERRUPTED: the same command goes on where it was cut.\n";
  }
  text += count_text(graded.submissions.size(), "submission") + " graded";
  const std::size_t not_judged = submissions_that(graded, false).size();
  if (not_judged > 0) text += fmt::format(", {} could not be judged", not_judged);
  if (graded.not_graded > 0) {
    text += fmt::format(", {} of them for causes outside: the same command tries again",
                        graded.not_graded);
  }
  if (graded.times) text += fmt::format(" ({})", times_text(*graded.times));
  return text + "\n";
}

}  // namespace raycheck::tools
