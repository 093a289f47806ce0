#ifndef RAYCHECK_TOOLS_GRADE_INTAKE_APART_H_
#define RAYCHECK_TOOLS_GRADE_INTAKE_APART_H_

#include <string>
#include <vector>

#include "tools/grade/intake/submission.h"

namespace raycheck::tools {

/// Throws std::invalid_argument where a folder of results, or one of a submission's name in it, is,
/// holds or lies in what is handed in, whatever links lead there. It need not be there.
void require_apart(const std::string& out, const std::vector<Submission>& submissions);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_INTAKE_APART_H_
