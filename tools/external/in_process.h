#pragma once

#include "tools/external/external_candidate.h"

namespace raycheck::tools {

/// The functions of someone else's shared library, called in raycheck's own process, where nothing
/// isolates it. It is loaded once and stays, since what it has started may still run.
/// Errors: CandidateError where it is isolated, or no such library.
InProcess calls_in_process(const External& external);

}  // namespace raycheck::tools
