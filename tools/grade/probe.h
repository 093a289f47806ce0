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

/// The result of a dry run of one submission.
struct SubmissionProbe {
  std::string name;
  Preparation found;
  std::set<std::string> functions;  ///< The functions it implements; empty for a renderer.
  std::optional<Refusal> refusal;   ///< Why it cannot be judged; empty if it can.
  /// The cause if a failure is not the submission's fault; otherwise empty.
  std::string outside = {};
};

/// The dry run of a class.
struct ProbeReport {
  Rubric rubric;
  std::vector<SubmissionProbe> submissions;  ///< In the given order, up to an interrupt.
  bool interrupted = false;

  /// Whether every submission can be judged.
  bool holds() const;
};

/// Builds and tries every submission like grade(), also with a second try after a failure that is
/// not the submission's fault. Judges and writes nothing.
/// Errors: as grade().
ProbeReport probe(const GradeOptions& options, const properties::RunControl& control = {});

/// The findings of the dry run as a part of a rubric, in TOML. First comes the table [driver] with
/// the form that most submissions read. Then, for each group of automatically built submissions
/// that one file name selects, comes a [[form]] with their build commands; last comes the form with
/// `build = "auto"` for all others. Empty if no submission runs.
std::string suggestion(const ProbeReport& report);

std::string probe_text(const ProbeReport& report, const ViewOptions& options);
std::string probe_json(const ProbeReport& report, const ViewOptions& options);

inline constexpr View<ProbeReport> kProbeViews[] = {{"text", probe_text}, {"json", probe_json}};

}  // namespace raycheck::tools
