#pragma once

#include <filesystem>

#include "tools/external/locate.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/store/store.h"

namespace raycheck::tools {

/// Builds what lies in a folder in the first way that works, in the time that the options allow for
/// all of them; what it made lies in the folder `to` then.
/// Errors: CandidateError with what the ways said, or why there is none.
Built build_as_it_comes(const std::filesystem::path& folder, const HandedInFiles& files,
                        const std::filesystem::path& to, const RunOptions& options);

}  // namespace raycheck::tools
