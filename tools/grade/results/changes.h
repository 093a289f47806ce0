#pragma once

// Scores beside those of an earlier grading, and why they changed.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/grade/results/result.h"

namespace raycheck::tools {

/// The file of a submission's results that records its grade.
inline constexpr const char* kRecordFile = "result.json";

/// What is known of a grade of an earlier run.
struct EarlierGrade {
  std::optional<double> score;  ///< Absent: it could not be judged.
  std::vector<std::pair<std::string, double>> items;
  std::uint64_t seed = 0;
  std::string isolation;
  std::optional<GradeInputs> inputs;  ///< Absent: by a raycheck that did not write them.
};

/// The grade that the results of a submission have, of this and of earlier shapes of records; empty
/// where there is none, or it was not finished.
std::optional<EarlierGrade> earlier_grade(const std::filesystem::path& folder);

/// What differs between two gradings of a submission.
enum class ChangeCause {
  kSubmission,  ///< Its files.
  kItems,       ///< Items of the rubric.
  kRubric,      ///< What the rubric says beside its items.
  kSeed,
  kRaycheck,  ///< Its version.
  kIsolation
};
inline constexpr std::array<std::string_view, 6> kChangeCauseNames = {
    "submission", "items", "rubric", "seed", "raycheck", "isolation"};
constexpr std::string_view name(ChangeCause cause) {
  return kChangeCauseNames[static_cast<std::size_t>(cause)];
}

/// Points before and now. Absent: it could not be judged, or the item was not there.
struct ScoreChange {
  std::string name;
  std::optional<double> before, now;
};

/// A submission whose points changed.
struct SubmissionChange {
  ScoreChange score;
  std::vector<ScoreChange> items;         ///< Those whose points changed.
  std::vector<ChangeCause> causes;        ///< Empty: it answers otherwise when it is asked again.
  std::vector<std::string> rubric_items;  ///< Those that the rubric changed, added or left out.
};

/// A class beside an earlier grading.
struct ClassChanges {
  std::string against;                       ///< The folder of that.
  std::uint64_t compared = 0, new_ones = 0;  ///< Submissions with a grade there, and without.
  std::vector<SubmissionChange> changed;
};

/// Empty where no points changed.
std::optional<SubmissionChange> change_of(const EarlierGrade& earlier, const SubmissionGrade& now);

}  // namespace raycheck::tools
