#pragma once

#include <string>
#include <string_view>

#include "tools/grade/results/result.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// Changes with the shape of records: those of another shape are graded again.
inline constexpr std::string_view kRecordShape = "record 11";

/// All that is known of a submission's grade, as JSON: for instructors, since it has what is
/// withheld from students, and for the next run.
std::string record_text(const SubmissionGrade& grade);

/// A form of driver files, by the keys of a rubric's [driver].
Json driver_json(const DriverForm& form);

/// Reads what record_text() wrote; how the submission was isolated is not read.
/// Errors: std::exception where it is no such thing.
SubmissionGrade read_record(std::string_view text);

}  // namespace raycheck::tools
