#pragma once

#include <filesystem>
#include <string>

#include "tools/external/locate.h"
#include "tools/grade/intake/handed_in.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/grade/store/store.h"

namespace raycheck::tools {

/// A submission before it is built.
struct Unbuilt {
  const Form& form;
  const std::string& file;              ///< What says that the form fits.
  const CandidateSpec& program;         ///< What the form makes of it.
  const std::filesystem::path& folder;  ///< A copy of the submission, with these files.
  const HandedInFiles& files;
  std::string contents;  ///< Their digest.
};

bool needs_building(const Unbuilt& submission);

/// Builds a submission in the empty folder `to`: by the form's words, in the first way that works,
/// or as a library of functions. Errors: CandidateError with what a compiler said, of several ways
/// with what each did.
Built build_submission(const Unbuilt& submission, const std::filesystem::path& to,
                       const RunOptions& options);

/// A digest of all that what is built depends on: the files, what is run on them, compilers, and
/// raycheck's version.
std::string build_key(const Unbuilt& submission, const Layers& layers);

}  // namespace raycheck::tools
