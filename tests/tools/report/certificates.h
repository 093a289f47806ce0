#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/tools/program.h"

namespace raycheck::tests {

using nlohmann::ordered_json;

// Scenes whose textbook discrepancies are certified here.
inline constexpr const char* kFalseHit = "tests/regressions/far-point-textbook-sees-a-hit.toml";
inline constexpr const char* kLostDigits =
    "tests/regressions/far-sphere-textbook-loses-digits.toml";
inline constexpr const char* kNearestByAnUlp = "tests/regressions/nearest-by-one-ulp.toml";
inline constexpr const char* kFarSphere = "scene/examples/far-sphere.toml";

/// The certificates of `check ARGUMENTS`; `report`, if given, becomes what it printed.
std::vector<ordered_json> certificates_of(const std::string& arguments,
                                          std::string* report = nullptr);

/// tools/verify_certificates.py on certificates that may be no longer what the program wrote.
Outcome script_on(const std::vector<ordered_json>& certificates);

/// What the script prints where it refutes nothing: a line for each, and what it counted.
std::vector<std::string> script_lines(const std::vector<ordered_json>& certificates);

/// The first certificate of a quantity; throws std::runtime_error when there is none.
ordered_json of_quantity(const std::vector<ordered_json>& certificates, const char* quantity);

}  // namespace raycheck::tests
