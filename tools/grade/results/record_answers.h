#pragma once

// The answers about one ray in a record. Internal to tools/grade/results/.

#include "tools/grade/results/result.h"
#include "tools/report/json.h"

namespace raycheck::tools {

Json answers_json(const RayAnswers& answers);

/// Reads what answers_json() wrote. Errors: std::exception where it is no such thing.
RayAnswers answers_of(const Json& json);

}  // namespace raycheck::tools
