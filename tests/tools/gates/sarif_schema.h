#ifndef RAYCHECK_TESTS_TOOLS_GATES_SARIF_SCHEMA_H_
#define RAYCHECK_TESTS_TOOLS_GATES_SARIF_SCHEMA_H_

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace raycheck::tests {

/// What in a SARIF log is not as sarif.schema.json has it, or does not fit together, in words;
/// empty where all is.
std::string defect_of_log(const nlohmann::json& log);

}  // namespace raycheck::tests

#endif  // RAYCHECK_TESTS_TOOLS_GATES_SARIF_SCHEMA_H_
