#ifndef RAYCHECK_TOOLS_GRADE_PAGES_H_
#define RAYCHECK_TOOLS_GRADE_PAGES_H_

#include <string>
#include <string_view>

#include "tools/grade/grade.h"

namespace raycheck::tools {

/// What students may see of an item: without what its detail withholds and without the names of
/// hidden ones.
ItemGrade thinned(const Rubric& rubric, const Item& item, ItemGrade grade);

/// What was asked and became of an item, as lines; of a thinned grade what students may read.
std::string item_text(const Item& item, const ItemGrade& grade);

/// A self-contained page for a student: the visible items alone, thinned.
std::string student_page(const Rubric& rubric, const SubmissionGrade& grade);

/// https://gradescope-autograders.readthedocs.io/en/latest/specs/
std::string gradescope_results(const Rubric& rubric, const SubmissionGrade& grade);
/// https://prairielearn.readthedocs.io/en/latest/externalGrading/ : hidden items count, but are not
/// listed.
std::string prairielearn_results(const Rubric& rubric, const SubmissionGrade& grade);

/// A row a submission, a column an item.
std::string class_csv(const ClassGrade& graded);
std::string class_json(const ClassGrade& graded);
/// A self-contained page for instructors: the scores, the items that fail most, the submissions
/// that fail on the same case in the same way.
std::string class_page(const ClassGrade& graded);
/// The table that the command prints.
std::string class_text(const ClassGrade& graded);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_PAGES_H_
