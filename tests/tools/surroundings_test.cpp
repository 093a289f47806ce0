// The program's environment: a standard output that is closed or full, a machine without apt-get
// (where ./run has few programs besides bash), names and files with control characters or bytes
// that are not UTF-8, and missing files.

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

/// A command without the name of the file or folder that it writes, and the first words of that
/// file.
struct WrittenReport {
  const char* arguments;
  const char* begins;
};

constexpr WrittenReport kWrittenReports[] = {
    {"check scene/examples/far-sphere.toml --intersect quadratic --certificates ", "{\"method\":"},
    {"check scene/examples/far-sphere.toml --intersect quadratic --report junit=", "<?xml "},
    {"properties --cases 20 --report junit=", "<?xml "},
    {"worst --method intersect/quadratic --family rays --cases 50 --steps 20 --save ", "# "},
    {"stress --method quadratic --family distance --cases 20 --certificates ", "{\"method\":"},
    {"grade lecture7.toml README.md --out ", ""},
    {"--help ", ""},
    {"check --help ", ""}};

Outcome run_to(const std::string& where, const std::string& arguments) {
  return run_bash("exec '" RAYCHECK_BINARY "' " + arguments + where);
}

TEST(UnwrittenReport, is_reported_and_files_are_complete) {
  const std::string path = temporary_file("written", "");
  for (const char* const where : {" >&-", " <&- >&-", " >/dev/full"}) {
    for (const auto& [arguments, begins] : kWrittenReports) {
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

/// Errors are not written to a file either.
TEST(UnwrittenReport, leaves_files_unchanged_when_errors_cannot_be_printed) {
  const std::string path = temporary_file("written", "");
  const Outcome outcome = run_to(" >&- 2>&-", kWrittenReports[0].arguments + ("'" + path + "'"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(contents(path).find(kWrittenReports[0].begins), 0u) << contents(path);
}

/// A fake CMake that has nothing to build, and a fake raycheck that prints its arguments.
const std::string kRun = R"bash(
set -e
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
eval "${then:-}"
)bash";

Outcome run_without_apt(const std::string& setting, int exit_code) {
  return run_bash("source='" RAYCHECK_SOURCE_DIR "'\n" + setting + kRun, exit_code);
}

TEST(RunScript, names_missing_packages_and_goes_on_if_they_are_installed) {
  expect_parts(run_without_apt("unset RAYCHECK_PACKAGES", 2).err,
               {" libflint-arb-dev or libflint-dev>=3 ", "RAYCHECK_PACKAGES=have"});
  const Outcome result = run_without_apt("export RAYCHECK_PACKAGES=have", 0);
  EXPECT_EQ(result.out, "check scene.toml\n");
  EXPECT_EQ(result.err, "building for the first time: a few minutes\n");
}

TEST(RunScript, does_not_ask_cmake_until_the_program_changes) {
  // A fake CMake leaves a file behind when it is called. After each change, the program is run.
  const Outcome result = run_without_apt(R"bash(export RAYCHECK_PACKAGES=have
more="chmod find rm sleep touch"
then='
PATH=$PWD/bin
rm bin/cmake
printf "#!/bin/bash\n: >asked\n" >bin/cmake
mkdir scene contract reference fast properties proofs library include
touch CMakeLists.txt CMakePresets.json build/release/tools/raycheck-check build/release/build.ninja
chmod +x bin/cmake build/release/tools/raycheck-check
for change in : : "touch scene/new.cpp" : "touch packages.txt" "rm scene/new.cpp" \
  "rm build/release/raycheck-check.built" :; do
  sleep 0.02
  $change
  ./run check >&2
  answer=nothing
  [ ! -f asked ] || answer=CMake
  [ ! -f asked ] || rm asked
  echo "$change: $answer"
done'
)bash",
                                         0);
  EXPECT_EQ(result.out,
            "check scene.toml\n:: CMake\n:: nothing\ntouch scene/new.cpp: CMake\n:: nothing\n"
            "touch packages.txt: CMake\nrm scene/new.cpp: CMake\n"
            "rm build/release/raycheck-check.built: CMake\n:: nothing\n");
}

TEST(RunScript, rejects_versions_that_are_too_old) {
  if (!is_installed("dpkg")) GTEST_SKIP() << "packages are of another kind here";
  const Outcome result = run_without_apt(
      "unset RAYCHECK_PACKAGES\nmore=dpkg\n"
      "query='[[ $4 == libflint-arb-dev ]] || echo ii 2.9.0'",
      2);
  EXPECT_TRUE(has(result.err, ": libflint-arb-dev or libflint-dev>=3"));
}

/// A copy of an example under a name with control characters that is not UTF-8.
class HostileNames : public testing::Test {
 protected:
  HostileNames() {
    for (const char* file : {"probe.toml", "driver-b.txt"}) {
      fs::copy_file(std::string(RAYCHECK_SOURCE_DIR "/scene/examples/") + file,
                    folder_ + "/" + file);
    }
  }

  std::string scene(const std::string& file) const { return " '" + folder_ + "/" + file + "' "; }

  /// The output has no control characters and is UTF-8 (as parsed by JSON).
  static void expect_plain(const Outcome& outcome) {
    for (const std::string& text : {outcome.out, outcome.err}) {
      EXPECT_FALSE(has(text, "\x1b"));
      EXPECT_FALSE(has(text, "\xff"));
      EXPECT_NO_THROW(json(text).dump()) << text;
    }
  }

  const std::string folder_ = temporary_folder("\x1b[31m\xff");
};

TEST_F(HostileNames, are_printed_in_every_format) {
  const std::vector<std::string> all = {
      "check" + scene("probe.toml"),
      "plan" + scene("driver-b.txt"),
      "explain" + scene("probe.toml") + "--pixel 3,3",
      "image" + scene("probe.toml") + "--out '" + folder_ + "/x.ppm'",
      "check" + scene("probe.toml") +
          "--candidate \"command:python3 tests/candidates/right.py \xff\x1b[31m\"",
      "tradeoff" + scene("probe.toml") + "--method cross"};
  for (const std::string& command : all) {
    const Outcome text = run(command, 0);
    expect_plain(text);
    const Outcome report = run(command + " --format json", 0);
    expect_plain(report);
    EXPECT_FALSE(json::parse(report.out).empty());
  }
  EXPECT_TRUE(has(run("check" + scene("probe.toml")).out, "\\x1b[31m\uFFFD"));
}

TEST_F(HostileNames, are_shown_in_errors) {
  const std::string hostile = "'\x1b[31m\xff'";
  std::vector<std::string> all = {"check" + scene("nowhere.toml"), "check" + scene(""),
                                  "grade" + scene("probe.toml"),
                                  "explain" + scene("probe.toml") + "--pixel 99,99",
                                  "check" + scene("probe.toml") + "--rays " + hostile};
  for (const char* before : {"", "check --", "check a ", "properties --filter ",
                             "properties --level ", "properties --replay "}) {
    all.push_back(before + hostile);
  }
  for (const std::string& arguments : all) {
    const Outcome outcome = run(arguments, 2);
    EXPECT_NE(outcome.err, "");
    expect_plain(outcome);
  }
}

TEST(HostileKeywords, are_shown) {
  const std::string file = temporary_file(
      "keywords.txt", "camera 0 0 10 0 0 0 0 1 0 -5\nbounds -1 1 -1 1\nres 4 4\n\x1b]0;\xff\a 1\n");
  for (const char* format : {"text", "json"}) {
    const Outcome outcome = run("check '" + file + "' --format " + format, 0);
    EXPECT_TRUE(has(outcome.err, "4: \\x1b]0;\uFFFD\\x07: unknown keyword"));
  }
}

/// A NUL byte, which ends C strings, does not cut messages.
TEST(HostileInput, with_a_nul_is_shown_in_whole_sentences) {
  const auto file = [](const std::string& name, const std::string& text) {
    return "'" + temporary_file(name, text) + "'";
  };
  const std::string nul(1, '\0');
  const std::string rubric = contents(RAYCHECK_SOURCE_DIR "/examples/rubrics/lecture7.toml");
  expect_refused("grade " + file("nul.toml", "bounds = \"cross\\u0000x\"\n" + rubric),
                 "nul.toml:1: bounds = \"cross\\x00x\": must not contain NUL\n");
  expect_refused("check scene/examples/driver-b.txt --baseline " +
                     file("known", "a; b; c; d; %4" + nul + "1\n"),
                 "line 1: '%4\\x00': expected % and two hexadecimal digits\n");
}

TEST(HostileInput, without_end_is_refused) {
  const std::string device = "/dev/zero: cannot be read: it is a device; give a file";
  expect_refused("check /dev/zero", device);
  expect_refused("plan /dev/zero", device);
  expect_refused("grade /dev/zero", device);
  expect_refused("grade lecture7.toml README.md --out nowhere --secret-file /dev/zero",
                 "--secret-file " + device);
  EXPECT_TRUE(has(run("check /dev/stdin </dev/zero").err, "it is a device"));
  expect_refused("check /tmp", "/tmp: cannot be read: it is a folder; give a file");
}

TEST(HostileInput, of_pipes_is_read) {
  const std::string file = RAYCHECK_SOURCE_DIR "/scene/examples/driver-b.txt";
  const Outcome of_file = run("plan '" + file + "' --format json");
  for (const char* const words : {"cat FILE | RAYCHECK plan /dev/stdin --format json",
                                  "RAYCHECK plan <(cat FILE) --format json"}) {
    const std::string script =
        replaced(replaced(words, "FILE", "'" + file + "'"), "RAYCHECK", "'" RAYCHECK_BINARY "'");
    const Outcome of_pipe = run_bash(script, 0);
    EXPECT_EQ(json::parse(of_pipe.out)["spheres"], json::parse(of_file.out)["spheres"]);
  }
}

}  // namespace
}  // namespace raycheck::tests
