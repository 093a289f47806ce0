// The folder in which a hand-in's renderer runs.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

class RunFolder : public testing::Test {
 protected:
  void SetUp() override {
    grading_.write("full.toml", kFullScene);
    rubric_ = grading_.write("rubric.toml", full_rubric(3));
  }
  void hand_in(const std::string& file, const std::string& text) const {
    grading_.write("mine/" + file, text);
  }
  nlohmann::json graded() const {
    grading_.grade(rubric_, {grading_.path("mine")});
    return grading_.result("mine");
  }
  void expect_full() const {
    const nlohmann::json result = graded();
    EXPECT_EQ(result["score"], 10) << result["refused"];
  }
  const Grading grading_;
  std::string rubric_;
};

/// Of hand-ins that make use of it.
class HostileRunFolder : public RunFolder {};

TEST_F(RunFolder, HasTheFoldersOfTheHandInEvenEmptyOnes) {
  hand_in("rt.py", white_renderer("", "'output/deep/image.ppm'"));
  fs::create_directories(grading_.path("mine/output/deep"));
  expect_full();
}

TEST_F(RunFolder, HasItsFiles) {
  hand_in("rt.py", white_renderer("assert open('config/size.txt').read() == 'large'\n"
                                  "assert len(open('config/table.txt').read()) == 300000\n"));
  hand_in("config/size.txt", "large");
  hand_in("config/table.txt", std::string(300000, '7'));
  expect_full();
}

TEST_F(HostileRunFolder, IsTheSameWheneverItRuns) {
  hand_in("rt.py", white_renderer("assert open('count.txt').read() == '0'\n"
                                  "assert not os.path.exists('new.txt')\n"
                                  "open('count.txt', 'w').write('1')\n"
                                  "open('new.txt', 'w')\n"));
  hand_in("count.txt", "0");
  expect_full();
}

TEST_F(HostileRunFolder, LetsNoRunChangeALargeFileOfALaterOne) {
  hand_in("rt.py", white_renderer("assert open('table.txt').read(1) == '7'\n"
                                  "try: open('table.txt', 'r+').write('8')\n"
                                  "except OSError: pass\n"
                                  "else: sys.exit(3 if os.path.islink('table.txt') else 0)\n"));
  hand_in("table.txt", std::string(300000, '7'));
  expect_full();
}

TEST_F(HostileRunFolder, HasNoPictureThatWasHandedIn) {
  // Of the likeliest name, of the name of the driver file, and folders of the names of a run.
  hand_in("rt.py", white_renderer("assert not os.path.exists('out.ppm')\n"
                                  "assert not os.path.exists('drawn')\n",
                                  "'mine.ppm'"));
  for (const char* const name :
       {"out.ppm", "scene.ppm", "drawn", "image.ppm/a.txt", "scene.txt/b"}) {
    hand_in(name, "P3 1 1 255 0 0 0\n");
  }
  hand_in("mine.ppm", "P3 1 1 255 0 0 0\n");
  const nlohmann::json result = graded();
  EXPECT_EQ(result["score"], 10) << result["refused"];
  EXPECT_EQ(result["notes"][0], "it writes mine.ppm whatever name it is given");
}

TEST_F(RunFolder, HasSoManyFilesThoseNearTheTopFirst) {
  hand_in("rt.py", white_renderer("assert os.path.exists('last.txt')\n"
                                  "count = sum(len(d) + len(f) for _, d, f in os.walk('.'))\n"
                                  "assert count == 101, count\n"));
  for (int k = 0; k < 150; ++k) hand_in("below/" + std::to_string(k) + ".txt", "few words");
  hand_in("last.txt", "");
  expect_full();
}

TEST_F(RunFolder, OfAnotherHandInIsNotTakenForAStoredOne) {
  hand_in("rt.py", white_renderer("", "'output/image.ppm'"));
  EXPECT_TRUE(graded()["refused"].is_object()) << "there is no folder output";
  fs::create_directories(grading_.path("mine/output"));
  expect_full();
}

}  // namespace
}  // namespace raycheck::tests
