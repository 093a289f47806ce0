#ifndef RAYCHECK_TOOLS_GRADE_WORDING_H_
#define RAYCHECK_TOOLS_GRADE_WORDING_H_

// The words that several views have for the same results.

#include <string>

#include "tools/grade/result.h"
#include "tools/grade/rubric.h"

namespace raycheck::tools {

/// At most two decimals, none that say nothing: "7", "2.5".
std::string points_text(double points);

/// "scene frame.toml", "course, random case 7"
std::string origin_text(const CaseOrigin& origin);

/// "class, pixel (3, 4), sphere 0: missed"
std::string answer_text(const WrongAnswer& answer);
/// The numbers, or "miss"; empty: none, or withheld.
std::string got_text(const WrongAnswer& answer);
std::string exact_text(const WrongAnswer& answer);

/// What someone's program or compiler said, without the names of raycheck's private folders and
/// without what is not ASCII.
std::string plain_text(const std::string& said);

/// Empty where there is none.
std::string reason_text(const ItemReason& reason);

/// "the far root is taken for the near one: 12 of 12 wrong answers are right that way"
std::string mistake_text(const ItemGrade& grade, const ExplainingMistake& mistake);

/// The mistake that explains most items; empty where none is known.
std::string mistake_text(const SubmissionGrade& grade);

/// "holds over 40 cases", "fails 3 of 40 cases", "left out: it needs ..."
std::string state_text(const ItemGrade& grade);

/// Why nothing could be run, and what the compiler said.
std::string refusal_text(const Refusal& refused);

/// The sentence of a failing case's law.
std::string law_text(const FailingCase& failing);
/// The case as a TOML scene; as a driver file, empty where it has no camera.
std::string scene_text(const FailingCase& failing);
std::string driver_file_text(const FailingCase& failing, scene::Dialect dialect);

/// What was asked and became of an item, as lines.
std::string item_text(const Item& item, const ItemGrade& grade, scene::Dialect dialect);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_WORDING_H_
