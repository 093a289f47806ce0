#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tools/grade/results/result.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// The file of a submission's results that records its grade.
inline constexpr const char* kRecordFile = "result.json";
/// Changes with the format of records: submissions with other records are graded again.
inline constexpr std::string_view kRecordShape = "record 12";

/// All that is known of a submission's grade, as JSON: for instructors, as it includes what is
/// withheld from students, and for the next run.
Json record_json(const SubmissionGrade& grade);

/// A form of driver files, by the keys of a rubric's [driver].
Json driver_json(const DriverForm& form);

/// Reads the text of such a record; how the submission was isolated is not read.
/// Errors: std::exception where it is no such thing.
SubmissionGrade read_record(std::string_view text);

/// A picture as runs of equal pixels: "12x- 3x0 4x?" are twelve without a sphere, three of sphere
/// 0, and four of some sphere.
std::string runs_of(const properties::ImageAnswer& image);
/// Reads what runs_of() wrote. Errors: std::logic_error where it is no such text, or of more pixels
/// than pictures have.
properties::ImageAnswer image_of(const std::string& runs);

}  // namespace raycheck::tools
