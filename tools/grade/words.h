#ifndef RAYCHECK_TOOLS_GRADE_WORDS_H_
#define RAYCHECK_TOOLS_GRADE_WORDS_H_

#include <string>
#include <string_view>

#include "tools/grade/result.h"

namespace raycheck::tools {

/// At most two decimals, none that say nothing: "7", "2.5".
std::string points_text(double points);

/// The mistake that explains most items; empty where none is known.
std::string mistake_text(const SubmissionGrade& grade);

/// "holds over 40 cases", "fails 3 of 40 cases", "left out: it needs ..."
std::string state_text(const ItemGrade& grade);

/// A name of letters, digits and hyphens for the files of an item.
std::string file_name(std::string_view item);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_WORDS_H_
