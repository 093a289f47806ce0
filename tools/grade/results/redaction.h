#pragma once

#include <string>
#include <vector>

#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// Who hides items that students may not see yet, or ever.
enum class HiddenBy {
  kUs,          ///< Only visible items are included.
  kOtherSystem  ///< All are included; hidden ones with their outcome, but no cases.
};

/// The part of a grade that a student may see: what is withheld is not in it, so that no view can
/// reveal it.
struct StudentGrade {
  std::string rubric;              ///< The name of its file.
  std::string dialect;             ///< What overrode its [driver]; or empty.
  std::string title;               ///< Of the rubric.
  SubmissionGrade submission;      ///< With visible items only; without the seed.
  std::vector<const Item*> items;  ///< The rubric's, one for each of these.
  std::size_t unlisted = 0;        ///< Items in the score that are not among them.
};

/// Domain: as many items graded as the rubric has, which outlives the result.
StudentGrade student_grade(const Rubric& rubric, const SubmissionGrade& grade, HiddenBy hidden_by);

}  // namespace raycheck::tools
