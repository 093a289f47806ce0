#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/grade/results/result.h"
#include "tools/report/json.h"

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

/// As records have them. Errors of the second: std::exception where it is no such thing.
Json inputs_json(const GradeInputs& inputs);
GradeInputs inputs_of(const Json& json);

}  // namespace raycheck::tools
