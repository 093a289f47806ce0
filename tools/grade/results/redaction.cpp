#include "tools/grade/results/redaction.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace raycheck::tools {
namespace {

bool is_visible(const Rubric& rubric, const std::string& item) {
  return std::any_of(rubric.items.begin(), rubric.items.end(), [&](const Item& one) {
    return one.name == item && one.visibility == Visibility::kVisible;
  });
}

/// The size of the error would tell the right answer.
void withhold_exact(WrongAnswer& answer) {
  answer.exact.reset();
  answer.error.reset();
  answer.condition.reset();
}

void withhold_exact(FailingCase& failing) {
  withhold_exact(failing.answer);
  failing.answers.reset();
  if (failing.pictures) failing.pictures->exact.reset();
}

ItemGrade redacted(const Rubric& rubric, const Item& item, ItemGrade grade) {
  if (!is_visible(rubric, grade.reason.item)) grade.reason.item.clear();
  grade.first_wrong.reset();
  const Detail detail = item.visibility == Visibility::kHidden ? Detail::kNothing : item.detail;
  if (detail == Detail::kNothing) {
    grade.failing.reset();
    grade.mistakes.clear();
  } else if (detail == Detail::kActualOnly && grade.failing) {
    withhold_exact(*grade.failing);
  }
  return grade;
}

}  // namespace

StudentGrade student_grade(const Rubric& rubric, const SubmissionGrade& grade, HiddenBy hidden_by) {
  StudentGrade result{std::filesystem::path(rubric.path).filename().string(),
                      rubric.dialect,
                      rubric.title,
                      grade,
                      {},
                      0};
  result.submission.seed = 0;
  result.submission.items.clear();
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const Item& item = rubric.items[k];
    if (item.visibility != Visibility::kVisible && hidden_by == HiddenBy::kUs) {
      ++result.unlisted;
      continue;
    }
    result.items.push_back(&item);
    result.submission.items.push_back(redacted(rubric, item, grade.items[k]));
  }
  return result;
}

}  // namespace raycheck::tools
