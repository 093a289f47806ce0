// Where standard output is closed or full, files have what they should, and the failure is said.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

/// A command without the file or folder that it writes, and what that begins with.
struct Written {
  const char* arguments;
  const char* begins;
};

constexpr Written kWritten[] = {
    {"check scene/examples/far-sphere.toml --intersect quadratic --certificates ", "{\"method\":"},
    {"check scene/examples/far-sphere.toml --intersect quadratic --report junit=", "<?xml "},
    {"properties --cases 20 --report junit=", "<?xml "},
    {"worst --method intersect/quadratic --family rays --cases 50 --steps 20 --save ", "# "},
    {"stress --method quadratic --family distance --cases 20 --certificates ", "{\"method\":"},
    {"grade lecture7.toml README.md --out ", ""},
    {"--help ", ""},
    {"check --help ", ""}};

Outcome run_to(const std::string& where, const std::string& arguments) {
  return run_bash(temporary_file("to.sh", "exec '" RAYCHECK_BINARY "' " + arguments + where));
}

TEST(UnwrittenReport, is_said_and_files_are_as_they_are_otherwise) {
  namespace fs = std::filesystem;
  const std::string path = temporary_file("written", "");
  for (const char* const where : {" >&-", " <&- >&-", " >/dev/full"}) {
    for (const auto& [arguments, begins] : kWritten) {
      fs::remove_all(path);
      const Outcome outcome = run_to(where, arguments + ("'" + path + "'"));
      EXPECT_EQ(outcome.exit_code, 2) << arguments << where << outcome.err;
      EXPECT_NE(outcome.err.find("raycheck: the report could not be written: "), std::string::npos)
          << arguments << where << outcome.err;
      EXPECT_EQ(contents(path).find(begins), 0u) << arguments << where << contents(path);
      if (std::string(arguments).starts_with("grade")) {
        EXPECT_TRUE(fs::exists(path + "/grades.csv")) << where;
      }
    }
  }
  fs::remove_all(path);
}

/// Nor do errors go to a file.
TEST(UnwrittenReport, leaves_files_alone_where_errors_cannot_be_said) {
  const std::string path = temporary_file("written", "");
  const Outcome outcome = run_to(" >&- 2>&-", kWritten[0].arguments + ("'" + path + "'"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(contents(path).find(kWritten[0].begins), 0u) << contents(path);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace raycheck::tests
