#ifndef RAYCHECK_TOOLS_GRADE_RESULTS_PLAIN_TEXT_H_
#define RAYCHECK_TOOLS_GRADE_RESULTS_PLAIN_TEXT_H_

#include <string>

namespace raycheck::tools {

/// What someone's program or compiler said, without the names of raycheck's private folders and
/// without what is not ASCII.
std::string plain_text(const std::string& said);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_RESULTS_PLAIN_TEXT_H_
