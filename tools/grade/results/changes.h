#pragma once

// Scores compared with those of an earlier grading, and why they changed.

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

/// What is known about an earlier run's grade.
struct EarlierGrade {
  std::optional<double> score;  ///< Absent: it could not be judged.
  std::vector<std::pair<std::string, double>> items;
  std::uint64_t seed = 0;
  std::string isolation;
  std::optional<GradeInputs> inputs;  ///< Absent: written by an older raycheck.
};

/// The grade in a submission's results, in this or an earlier shape of records; empty if there is
/// none, or it is unfinished.
std::optional<EarlierGrade> earlier_grade(const std::filesystem::path& folder);

/// Empty if no points changed.
std::optional<SubmissionChange> change_of(const EarlierGrade& earlier, const SubmissionGrade& now);

}  // namespace raycheck::tools
