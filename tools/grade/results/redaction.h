#pragma once

#include <string>
#include <vector>

#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// Who keeps students from items that they are not to see yet, or ever.
enum class HiddenBy {
  kUs,          ///< Visible items alone are there.
  kOtherSystem  ///< All are there; of hidden ones what became of them, without any case.
};

/// What a student may be given of a grade: what is withheld is no longer in it, so that no view of
/// it can tell.
struct StudentGrade {
  std::string rubric;              ///< The name of its file.
  std::string dialect;             ///< What its [driver] gave way to; or empty.
  std::string title;               ///< Of the rubric.
  SubmissionGrade submission;      ///< Its items alone that may be seen; without seed and key.
  std::vector<const Item*> items;  ///< Of the rubric, one for each of these.
  std::size_t unlisted = 0;        ///< Items in the score that are not among them.
};

/// Domain: as many items graded as the rubric has, which outlives the result.
StudentGrade student_grade(const Rubric& rubric, const SubmissionGrade& grade, HiddenBy hidden_by);

}  // namespace raycheck::tools
