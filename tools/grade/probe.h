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
  std::optional<Refusal> refusal;   ///< Why it cannot be judged; absent if it can.
  std::string outside = {};         ///< Non-empty: the cause lies outside the submission.
};

/// The dry run of a class.
struct ProbeReport {
  Rubric rubric;
  std::vector<SubmissionProbe> submissions;  ///< In the given order, as far as reached.
  bool interrupted = false;

  /// Whether every submission can be judged.
  bool holds() const;
};

/// Builds and tries every submission as grade() does, and again if it failed for a cause outside
/// it; judges and writes nothing.
/// Errors: as grade().
ProbeReport probe(const GradeOptions& options, const properties::RunControl& control = {});

/// The findings of the dry run as a part of a rubric, in TOML: the table [driver] with the form
/// that most submissions read; for each group of automatically built submissions that one file name
/// selects, a [[form]] with its build commands; last, the form `build = "auto"`. Empty if no
/// submission runs.
std::string suggestion(const ProbeReport& report);

std::string probe_text(const ProbeReport& report, const ViewOptions& options);
std::string probe_json(const ProbeReport& report, const ViewOptions& options);

inline constexpr View<ProbeReport> kProbeViews[] = {{"text", probe_text}, {"json", probe_json}};

}  // namespace raycheck::tools
