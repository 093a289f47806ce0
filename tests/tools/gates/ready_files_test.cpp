// The files for pipelines that are ready to be copied: their raycheck commands run as they stand.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "tests/tools/limited_run.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

/// The raycheck commands of a file: lines that begin with it once the file's own signs are gone.
std::vector<std::string> commands_of(const std::string& file) {
  static const std::regex command(" *(?:- |entry: |run: )*(raycheck prope.*)");
  std::vector<std::string> commands;
  for (const std::string& line : lines_of(contents(RAYCHECK_SOURCE_DIR "/" + file))) {
    std::smatch found;
    if (std::regex_match(line, found, command)) commands.push_back(found[1]);
  }
  return commands;
}

class LongReadyFile : public testing::TestWithParam<const char*> {};

TEST_P(LongReadyFile, GatesAProjectThatIsRightAndOneThatIsNot) {
  const auto commands = commands_of(GetParam());
  ASSERT_EQ(commands.size(), 1u);
  const TestFolder its;
  const fs::path folder = its.path();
  fs::create_directories(folder / "src");
  std::ofstream(folder / "raycheck.baseline").flush();
  for (const char* name : {"none", "far_root"}) {
    const std::string built = built_submission("rays.cpp", name, folder / "src");
    // The hook is given its candidate as an argument, the others by the environment.
    const bool is_hook = std::string(GetParam()).ends_with("hooks.yaml");
    const std::string script = temporary_file(
        "ready.sh", "set -e\ncd " + folder.string() + "\nmkdir -p raycheck-reports\nPATH=" +
                        fs::path(RAYCHECK_BINARY).parent_path().string() +
                        ":$PATH\nexport CANDIDATE=library:" + built +
                        " BASELINE=raycheck.baseline CASES=500 GITHUB_STEP_SUMMARY=summary.md\n" +
                        commands.front() + (is_hook ? " --candidate \"$CANDIDATE\"" : "") + "\n");
    const Outcome outcome = run_bash(script);
    EXPECT_EQ(outcome.exit_code, std::string(name) == "none" ? 0 : 1) << outcome.out << outcome.err;
  }
  const bool is_github = std::string(GetParam()).find("github/") != std::string::npos;
  EXPECT_EQ(fs::exists(folder / "summary.md"), is_github);
}

INSTANTIATE_TEST_SUITE_P(Files, LongReadyFile,
                         testing::Values("examples/ci/github/workflow.yml",
                                         "examples/ci/github/action.yml",
                                         "examples/ci/gitlab/raycheck.gitlab-ci.yml",
                                         ".pre-commit-hooks.yaml"));

TEST(ReadyFiles, SayWhichIsolationTheyGet) {
  for (const char* file : {"examples/ci/github/workflow.yml", "examples/ci/github/action.yml",
                           "examples/ci/gitlab/raycheck.gitlab-ci.yml",
                           "examples/ci/container/Containerfile", ".pre-commit-hooks.yaml"}) {
    const std::string text = contents(RAYCHECK_SOURCE_DIR "/" + std::string(file));
    EXPECT_TRUE(has(text, "solation")) << file;
  }
  const std::string container =
      contents(RAYCHECK_SOURCE_DIR "/examples/ci/container/Containerfile");
  EXPECT_TRUE(has(container, "\nUSER raycheck\n"));
}

}  // namespace
}  // namespace raycheck::tests
