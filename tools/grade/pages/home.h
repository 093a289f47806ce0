#pragma once

// How students repeat at home what was graded.

#include <cstddef>
#include <string>
#include <vector>

#include "tools/grade/results/redaction.h"

namespace raycheck::tools {

/// A command line, and what it is for.
struct HomeCommand {
  std::string purpose;
  std::string words;
};

/// Those that build the submission as it was built here, and repeat the failing case of item k, its
/// files beside the submission's; empty where it has none.
std::vector<HomeCommand> commands_for_case(const StudentGrade& grade, std::size_t k);

/// What grades the submission again, as far as it is shown, in its folder.
HomeCommand command_for_all(const StudentGrade& grade);

}  // namespace raycheck::tools
