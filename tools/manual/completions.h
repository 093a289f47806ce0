#pragma once

// Scripts by which shells complete commands, options and files. Internal to the manual.

#include "tools/manual/manual.h"

namespace raycheck::tools {

std::string bash_completion(const ManualCommand& program, std::span<const ManualCommand> commands);
std::string zsh_completion(const ManualCommand& program, std::span<const ManualCommand> commands);
std::string fish_completion(const ManualCommand& program, std::span<const ManualCommand> commands);

}  // namespace raycheck::tools
