#ifndef RAYCHECK_TESTS_TOOLS_REPORT_CERTIFICATE_SCRIPT_H_
#define RAYCHECK_TESTS_TOOLS_REPORT_CERTIFICATE_SCRIPT_H_

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/report/certificate.h"

namespace raycheck::tools {

/// What tools/verify_certificates.py prints: a line for each certificate, and what it counted.
inline std::vector<std::string> script_on(const std::vector<Json>& certificates) {
  const std::string stem = testing::TempDir() + "raycheck_certificates_" + std::to_string(getpid());
  std::ofstream(stem + ".jsonl") << certificates_text(certificates);
  const std::string command = "python3 '" RAYCHECK_SOURCE_DIR "/tools/verify_certificates.py' '" +
                              stem + ".jsonl' > '" + stem + ".txt'";
  EXPECT_EQ(std::system(command.c_str()), 0) << "python3 is needed: " << command;
  std::vector<std::string> lines;
  std::ifstream in(stem + ".txt");
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::filesystem::remove(stem + ".jsonl");
  std::filesystem::remove(stem + ".txt");
  EXPECT_GT(lines.size(), certificates.size());
  return lines;
}

}  // namespace raycheck::tools

#endif  // RAYCHECK_TESTS_TOOLS_REPORT_CERTIFICATE_SCRIPT_H_
