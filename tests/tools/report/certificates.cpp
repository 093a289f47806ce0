#include "tests/tools/report/certificates.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

namespace raycheck::tests {

std::vector<ordered_json> certificates_of(const std::string& arguments, std::string* report) {
  const std::string path = temporary_file("certificates.jsonl", "");
  const Outcome checked = run("check " + arguments + " --certificates " + path);
  EXPECT_TRUE(checked.exit_code != 2) << checked.err;
  if (report != nullptr) *report = checked.out;
  std::vector<ordered_json> certificates;
  const std::string text = contents(path);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    certificates.push_back(ordered_json::parse(text.substr(at, end - at)));
    at = end + 1;
  }
  std::filesystem::remove(path);
  return certificates;
}

Outcome script_on(const std::vector<ordered_json>& certificates) {
  std::string text;
  for (const ordered_json& one : certificates) text += one.dump() + "\n";
  const std::string path = temporary_file("certificates.jsonl", text);
  const Outcome result = run_python("tools/verify_certificates.py " + path);
  std::filesystem::remove(path);
  return result;
}

ordered_json of_quantity(const std::vector<ordered_json>& certificates, const char* quantity) {
  for (const ordered_json& one : certificates) {
    if (one.at("quantity") == quantity) return one;
  }
  throw std::runtime_error(std::string("no certificate of a ") + quantity);
}

}  // namespace raycheck::tests
