// The commands that a student's page names are run at home, in a copy of the hand-in.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

/// Enough to fail by what is wrong with the camera.
constexpr const char* kFewPictures = R"(
[[form]]
has = "*"
build = "auto"
candidate = "renderer:{program} {scene} {image}"

[[item]]
name = "a few pictures"
points = 10
[item.pictures]
judge = "mask"
scenes = ["lecture7/wide.toml", "lecture7/orientation.toml"]
)";

/// What stands behind `label` in its first line of a report; empty: nowhere.
std::string stands_behind(const std::string& report, const std::string& label) {
  const std::size_t at = report.find("\n  " + label);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + 3 + label.size();
  return report.substr(begin, report.find('\n', begin) - begin);
}

/// Tries a hand-in with a mistake, and does in a copy of its folder what the report says of the
/// first item that fails.
void expect_the_commands_to_work(const Grading& grading, const std::string& hand_in) {
  const std::string rubric = grading.write("few.toml", kFewPictures);
  const Outcome tried =
      run("try '" + rubric + "' '" + hand_in + "' --out '" + grading.path("out") + "'");
  ASSERT_EQ(tried.exit_code, 1) << tried.err;
  const std::string build =
      stands_behind(tried.out, "Build it as here, in a copy of your folder: ");
  const std::string draw = stands_behind(tried.out, "Draw it: ");
  const std::string check = stands_behind(tried.out, "Judge every pixel of it: ");
  ASSERT_FALSE(build.empty()) << tried.out;
  ASSERT_FALSE(draw.empty()) << tried.out;
  ASSERT_FALSE(check.empty()) << tried.out;
  const std::string home = grading.path("home");
  fs::copy(hand_in, home, fs::copy_options::recursive);
  for (const auto& entry :
       fs::directory_iterator(grading.path("out/" + fs::path(hand_in).filename().string()))) {
    fs::copy(entry.path(), home, fs::copy_options::recursive);
  }
  const Outcome at_home = run_bash(grading.write(
      "home.sh", "raycheck() { '" RAYCHECK_BINARY "' \"$@\"; }\ncd '" + home + "'\n" + build +
                     " > /dev/null || exit 10\n" + draw + " > /dev/null || exit 11\n" + check));
  EXPECT_EQ(at_home.exit_code, 1) << "it fails there, too\n"
                                  << build << "\n"
                                  << draw << "\n"
                                  << check << "\n"
                                  << at_home.out << at_home.err;
  expect_parts(at_home.out, {"image"});
}

TEST(Home, BuildsAsItWasBuilt) {
  const std::string line = "#define MISTAKE width_height";
  {
    const Grading grading;
    expect_the_commands_to_work(grading, grading.submit("mine", "rt.cpp", line));
  }
  {
    // By a Makefile in a folder below, without leaving the folder.
    const Grading grading;
    const std::string folder = grading.submit("mine/src", "rt.cpp", line);
    grading.write("submissions/mine/src/Makefile", "rt: rt.cpp\n\tg++ -O1 -o rt rt.cpp\n");
    grading.write("submissions/mine/readme.txt", "see src\n");
    expect_the_commands_to_work(grading, fs::path(folder).parent_path());
  }
  for (const char* name : {"emil", "lena"}) {
    if (name == std::string("lena") && !is_installed("javac")) continue;
    const Grading grading;
    expect_the_commands_to_work(
        grading, RAYCHECK_SOURCE_DIR "/tests/submissions/class/" + std::string(name));
  }
}

}  // namespace
}  // namespace raycheck::tests
