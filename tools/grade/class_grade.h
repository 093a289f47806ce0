#ifndef RAYCHECK_TOOLS_GRADE_CLASS_GRADE_H_
#define RAYCHECK_TOOLS_GRADE_CLASS_GRADE_H_

#include <cstdint>
#include <string>
#include <vector>

#include "tools/grade/result.h"
#include "tools/grade/rubric.h"

namespace raycheck::tools {

/// A class, graded.
struct ClassGrade {
  Rubric rubric;
  std::string out;                           ///< Where the results are; empty: nowhere.
  std::vector<SubmissionGrade> submissions;  ///< In the order given; those that were reached.
  std::uint64_t reused = 0;                  ///< Of those, graded by an earlier run.
  bool interrupted = false;
};

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_CLASS_GRADE_H_
