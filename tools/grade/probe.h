#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "properties/run_control.h"
#include "tools/grade/grade.h"
#include "tools/grade/intake/prepare.h"
#include "tools/grade/results/result.h"

namespace raycheck::tools {

/// What is known of a submission before anything of it is judged.
struct SubmissionProbe {
  std::string name;
  Preparation found;
  std::set<std::string> functions;  ///< That it offers; none of a renderer.
  std::optional<Refusal> refusal;   ///< Why nothing of it can be judged.
};

/// The dry run of a class.
struct ProbeReport {
  Rubric rubric;
  std::vector<SubmissionProbe> submissions;  ///< In the order given; those that were reached.
  bool interrupted = false;

  /// Every submission can be judged.
  bool holds() const;
};

/// Builds and tries every submission as grade() does, also again, alone, judges nothing and writes
/// nothing.
/// Errors: what grade() throws.
ProbeReport probe(const GradeOptions& options, const properties::RunControl& control = {});

}  // namespace raycheck::tools
