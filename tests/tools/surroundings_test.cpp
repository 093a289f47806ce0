// What surrounds the program: a standard output that is closed or full, by which no file loses what
// it should have, and a machine without apt-get, where `./run` is in a folder with few programs
// beside bash.

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
      EXPECT_TRUE(has(outcome.err, "raycheck: the report could not be written: "))
          << arguments << where;
      EXPECT_EQ(contents(path).find(begins), 0u) << arguments << where << contents(path);
      if (std::string(arguments).starts_with("grade")) {
        EXPECT_TRUE(fs::exists(path + "/grades.csv")) << where;
      }
    }
  }
}

/// Nor do errors go to a file.
TEST(UnwrittenReport, leaves_files_alone_where_errors_cannot_be_said) {
  const std::string path = temporary_file("written", "");
  const Outcome outcome = run_to(" >&- 2>&-", kWritten[0].arguments + ("'" + path + "'"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(contents(path).find(kWritten[0].begins), 0u) << contents(path);
}

/// Of a CMake that has nothing to build, and of a raycheck that prints its arguments.
const std::string kRun = R"bash(
set -e
unset RAYCHECK_PEERS
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
mkdir -p bin build/release/tools tools
cp "$source/run" "$source/packages.txt" .
cp "$source/tools/commands.h" tools
for program in bash cat dirname flock mkdir tee; do
  ln -s "$(type -P "$program")" bin
done
for program in $more; do
  ln -s "$(type -P "$program")" bin
done
if [ -n "${query:-}" ]; then
  printf '#!/bin/bash\n%s\n' "$query" >bin/dpkg-query
  chmod +x bin/dpkg-query
fi
ln -s "$(type -P true)" bin/cmake
ln -s "$(type -P echo)" build/release/tools/raycheck
PATH=$PWD/bin ./run check scene.toml
)bash";

Outcome run_without_apt(const std::string& setting) {
  return run_bash(
      temporary_file("elsewhere.sh", "source='" RAYCHECK_SOURCE_DIR "'\n" + setting + kRun));
}

TEST(RunScript, names_the_packages_where_nothing_installs_them) {
  const Outcome result = run_without_apt("unset RAYCHECK_PACKAGES");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(has(result.err, " libflint-arb-dev or libflint-dev>=3 "));
  EXPECT_TRUE(has(result.err, "RAYCHECK_PACKAGES=have"));
}

TEST(RunScript, takes_an_older_package_for_none_where_it_holds_less) {
  if (!is_installed("dpkg")) GTEST_SKIP() << "packages are of another kind here";
  const Outcome result = run_without_apt(
      "unset RAYCHECK_PACKAGES\nmore=dpkg\n"
      "query='[[ $4 == libflint-arb-dev ]] || echo ii 2.9.0'");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, " calls libflint-arb-dev or libflint-dev>=3, "));
}

TEST(RunScript, goes_on_where_the_packages_are_there_in_another_way) {
  const Outcome result = run_without_apt("export RAYCHECK_PACKAGES=have");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "check scene.toml\n");
  EXPECT_EQ(result.err, "building for the first time: a few minutes\n");
}

}  // namespace
}  // namespace raycheck::tests
