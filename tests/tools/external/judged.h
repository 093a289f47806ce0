#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/tools/program.h"

namespace raycheck::tests {

/// For root, who has to say so.
inline const std::string kUnkept =
    std::string(" --sandbox none") + (geteuid() == 0 ? " --i-know" : "");

/// What `check` says of someone else's candidate on a scene.
inline Outcome check(const std::string& scene, const std::string& candidate,
                     const std::string& more = "") {
  return run("check " + scene + " --format json " + more + " --candidate '" + candidate + "'");
}

inline nlohmann::json judged(const std::string& scene, const std::string& candidate,
                             const std::string& more = "") {
  const Outcome outcome = check(scene, candidate, more);
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1)
      << candidate << ": " << outcome.exit_code << "\n"
      << outcome.err;
  if (outcome.out.empty()) return {};
  return nlohmann::json::parse(outcome.out)["candidates"][0];
}

/// What `check` says of one quantity; null: nothing.
inline nlohmann::json quantity_of(const nlohmann::json& quantities, const std::string& name) {
  for (const nlohmann::json& one : quantities) {
    if (one["name"] == name) return one;
  }
  return {};
}

/// What a command says as JSON, which ends with this.
inline nlohmann::json report_of(const std::string& arguments, const std::string& candidate,
                                int exit_code) {
  const Outcome outcome = run(arguments + " --format json --candidate '" + candidate + "'");
  EXPECT_EQ(outcome.exit_code, exit_code) << arguments << "\n" << outcome.out << outcome.err;
  return nlohmann::json::parse(outcome.out, nullptr, false);
}

/// A renderer of these lines of Python, which comes after imports; these words are before its
/// files.
inline std::string python_renderer(const std::string& lines, const std::string& words = "") {
  static int count = 0;
  const std::string path =
      temporary_file("lines" + std::to_string(++count) + ".py",
                     "import ctypes, os, signal, subprocess, sys, time\n" + lines + "\n");
  return "renderer:python3 " + path + " " + words + (words.empty() ? "" : " ") + "{scene} {image}";
}

/// The processes whose command line has this text.
inline std::vector<pid_t> processes_with(const std::string& text) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    if (!has(contents(entry.path() / "cmdline"), text)) continue;
    found.push_back(std::atoi(entry.path().filename().c_str()));
  }
  return found;
}

/// tests/candidates/right.cpp, built once for all tests.
inline const std::string& right_library() {
  static const std::string library =
      "library:" + built_submission("right.cpp", "right", temporary_file("library", "") + ".d");
  return library;
}

}  // namespace raycheck::tests
