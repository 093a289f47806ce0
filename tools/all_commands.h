#pragma once

#include "tools/commands.h"

namespace raycheck::tools {

/// Of all programs, for who links them all: the manual, and tests.
inline constexpr LinkedCommand kAllCommands[] = {
#define RAYCHECK_LINKED(name, program, sentence) {#name, add_##name},
    RAYCHECK_COMMANDS(RAYCHECK_LINKED)
#undef RAYCHECK_LINKED
};

}  // namespace raycheck::tools
