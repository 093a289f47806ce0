#pragma once

#include <string>

namespace raycheck::tools {

/// Goes on as a child of this process, which stays to take what that leaves behind: it ends as the
/// child does, when nothing that the child started is left, and kills all of it when its own parent
/// dies. `group`: the folder of the control group in which the child begins; empty: that of this
/// process. False, with errno, where it cannot.
bool supervise(const std::string& group);

}  // namespace raycheck::tools
