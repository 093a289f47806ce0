#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "properties/run_control.h"
#include "tools/grade/grade.h"
#include "tools/grade/intake/prepare.h"
#include "tools/grade/results/result.h"
#include "tools/report/view.h"

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

/// A part of a rubric, in TOML, under which the submissions run as the dry run made them run: the
/// table [driver] with the form that most read, and of those that are built automatically each
/// [[form]] that says so in words of its own and fits no others, then the form that fits the rest.
/// Empty: nothing runs that it could be made of.
std::string suggestion(const ProbeReport& report);

std::string probe_text(const ProbeReport& report, const ViewOptions& options);
std::string probe_json(const ProbeReport& report, const ViewOptions& options);

inline constexpr View<ProbeReport> kProbeViews[] = {{"text", probe_text}, {"json", probe_json}};

}  // namespace raycheck::tools
