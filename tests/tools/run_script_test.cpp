// `./run` where there is no apt-get: in a folder with the script, and with few programs beside
// bash.

#include <gtest/gtest.h>

#include <string>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

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
  EXPECT_NE(result.err.find(" libflint-arb-dev or libflint-dev>=3 "), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("RAYCHECK_PACKAGES=have"), std::string::npos) << result.err;
}

TEST(RunScript, takes_an_older_package_for_none_where_it_holds_less) {
  if (!is_installed("dpkg")) GTEST_SKIP() << "packages are of another kind here";
  const Outcome result = run_without_apt(
      "unset RAYCHECK_PACKAGES\nmore=dpkg\n"
      "query='[[ $4 == libflint-arb-dev ]] || echo ii 2.9.0'");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find(" calls libflint-arb-dev or libflint-dev>=3, "), std::string::npos)
      << result.err;
}

TEST(RunScript, goes_on_where_the_packages_are_there_in_another_way) {
  const Outcome result = run_without_apt("export RAYCHECK_PACKAGES=have");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "check scene.toml\n");
  EXPECT_EQ(result.err, "building for the first time: a few minutes\n");
}

}  // namespace
}  // namespace raycheck::tests
