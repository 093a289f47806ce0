#pragma once

#include <memory>
#include <string>

#include "properties/run_control.h"
#include "tools/external/locate.h"
#include "tools/external/sandbox/private_folder.h"
#include "tools/grade/intake/submission.h"
#include "tools/grade/store/store.h"

namespace raycheck::tools {

/// A submission that is built; one or several programs are there to be started.
struct BuiltSubmission {
  const Rubric& rubric;
  CandidateSpec program;  ///< As the form has it, with {file}.
  Preparation found;
  RunOptions options;
  Store* store = nullptr;  ///< Null: nothing is kept.
  std::string key = {};    ///< Of what was built, in the store.
  Built made = {};
  std::shared_ptr<const PrivateFolder> folder = {};  ///< Where the programs lie.
  std::shared_ptr<const StartingFolder> start = {};  ///< Where a renderer runs.
  bool is_stored = false;
  double seconds = 0;  ///< To build it.
};

/// The first of its programs that shows spheres, or introduces itself; else the first that makes a
/// picture. Errors: SubmissionError of the likeliest where none does.
RunnableSubmission likeliest(const BuiltSubmission& built, const properties::RunControl& control);

}  // namespace raycheck::tools
