#pragma once

#include <string>
#include <vector>

#include "tools/grade/intake/submission.h"

namespace raycheck::tools {

/// Throws std::invalid_argument where a folder of results, or one of a submission's name in it, is,
/// holds or lies in what is handed in, whatever links lead there. It need not be there.
void require_apart(const std::string& out, const std::vector<Submission>& submissions);

}  // namespace raycheck::tools
