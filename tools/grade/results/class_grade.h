#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/grade/results/changes.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// What a run took for the submissions that it graded itself, added up.
struct GradingTimes {
  double build_seconds = 0, judge_seconds = 0;
  std::uint64_t stored_builds = 0;  ///< Submissions that were not built, but taken from the store.
};

/// A class, graded.
struct ClassGrade {
  Rubric rubric;
  std::string out;                           ///< Where the results are; empty: nowhere.
  std::vector<SubmissionGrade> submissions;  ///< In the order given; those that were reached.
  std::optional<LayersHere> isolation = {};  ///< Absent: none was run.
  std::uint64_t reused = 0;                  ///< Of those, graded by an earlier run.
  std::uint64_t not_graded = 0;  ///< For causes outside them, which may have gone next time.
  bool interrupted = false;
  std::optional<GradingTimes> times = {};    ///< Absent: nothing was run.
  std::optional<ClassChanges> changes = {};  ///< Where an earlier grading is given.
};

}  // namespace raycheck::tools
