#pragma once

#include "tests/tools/program.h"

namespace raycheck::tests {

using nlohmann::ordered_json;

// Scenes whose textbook discrepancies are certified here.
inline const std::string kFalseHit = "tests/regressions/far-point-textbook-finds-a-hit.toml";
inline const std::string kLostDigits = "tests/regressions/far-sphere-textbook-loses-digits.toml";
inline const std::string kNearestByAnUlp = "tests/regressions/nearest-by-one-ulp.toml";
inline const std::string kFarSphere = "scene/examples/far-sphere.toml";

/// The certificates of `check ARGUMENTS`; `report`, if not null, receives the output.
inline std::vector<ordered_json> certificates_of(const std::string& arguments,
                                                 std::string* report = nullptr) {
  const std::string path = temporary_file("certificates.jsonl", "");
  const Outcome checked = run("check " + arguments + " --certificates " + path);
  EXPECT_TRUE(checked.exit_code != 2) << checked.err;
  if (report != nullptr) *report = checked.out;
  std::vector<ordered_json> certificates;
  for (const std::string& line : lines_of(contents(path))) {
    certificates.push_back(ordered_json::parse(line));
  }
  return certificates;
}

/// Runs tools/verify_certificates.py on certificates, which may have been changed.
inline Outcome script_on(const std::vector<ordered_json>& certificates) {
  std::string text;
  for (const ordered_json& one : certificates) text += one.dump() + "\n";
  const std::string path = temporary_file("certificates.jsonl", text);
  return run_python("tools/verify_certificates.py " + path);
}

/// The lines that the script prints if it refutes nothing: one for each certificate, and the
/// counts.
inline std::vector<std::string> script_lines(const std::vector<ordered_json>& certificates) {
  const Outcome outcome = script_on(certificates);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  std::vector<std::string> lines = lines_of(outcome.out);
  EXPECT_GT(lines.size(), certificates.size());
  return lines;
}

/// The first certificate of a quantity; throws std::runtime_error if there is none.
inline ordered_json of_quantity(const std::vector<ordered_json>& certificates,
                                const char* quantity) {
  for (const ordered_json& one : certificates) {
    if (one.at("quantity") == quantity) return one;
  }
  throw std::runtime_error(std::string("no certificate of a ") + quantity);
}

}  // namespace raycheck::tests
