#pragma once

// Scores beside those of an earlier grading, and why they changed.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
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

/// Empty where no points changed.
std::optional<SubmissionChange> change_of(const EarlierGrade& earlier, const SubmissionGrade& now);

}  // namespace raycheck::tools
