#pragma once

#include "tools/grade/results/result.h"
#include "tools/report/json.h"

namespace raycheck::tools {

/// A submission's complete grade as JSON, including what is withheld from students.
Json record_json(const SubmissionGrade& grade);

/// A form of driver files, by the keys of a rubric's [driver].
Json driver_json(const DriverForm& form);

Json refusal_json(const Refusal& refusal);

}  // namespace raycheck::tools
