#pragma once

// The pages of manual.h, in the macros of man(7). Internal to the manual.

#include "tools/manual/manual.h"

namespace raycheck::tools {

std::string program_page(const ManualCommand& program, const std::string& version,
                         std::span<const ManualCommand> commands);
std::string command_page(const ManualCommand& command, const std::string& version);

}  // namespace raycheck::tools
