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

/// What is known about a submission before it is judged.
struct SubmissionProbe {
  std::string name;
  Preparation found;
  std::set<std::string> functions;  ///< Those it offers; none for a renderer.
  std::optional<Refusal> refusal;   ///< Why it cannot be judged at all.
  std::string outside = {};         ///< The cause outside it of that; empty: its own.
};

/// The dry run of a class.
struct ProbeReport {
  Rubric rubric;
  std::vector<SubmissionProbe> submissions;  ///< In the given order, as far as reached.
  bool interrupted = false;

  /// Whether every submission can be judged.
  bool holds() const;
};

/// Builds and tries every submission as grade() does, if need be again on its own; judges and
/// writes nothing.
/// Errors: as grade().
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
