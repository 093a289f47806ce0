// Cases that a wrapper's form of scene files cannot express: they leave the total, by the word of
// the instructor's wrapper alone.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// wrap.py PROGRAM... SCENE IMAGE, whose form has no bounds that are not symmetric.
constexpr const char* kWrapper = R"py(import subprocess, sys
*program, scene, image = sys.argv[1:]
for line in open(scene):
    word, *rest = line.split() or ['']
    if word == 'bounds' and float(rest[0]) != -float(rest[1]): sys.exit(77)
sys.exit(subprocess.call([*program, scene, image]))
)py";

/// It draws what the dry run asks, and nothing else.
constexpr const char* kDull = "if h < 25: sys.exit(77)\n";

class Unsaid : public GradingTest {
 protected:
  Unsaid() {
    grading.write("full.toml", kFullScene);
    std::string uneven = kFullScene;
    uneven.replace(uneven.find("right = 1"), 9, "right = 2");
    grading.write("uneven.toml", uneven);
    grading.write("submissions/right/main.py", renderer_in_python());
    grading.write("submissions/dull/main.py", renderer_in_python(kDull));
  }

  /// Both, graded by a rubric with these words before {scene}.
  void grade(const std::string& words, const std::string& more = "") {
    const auto item = [](const std::string& name, const std::string& scenes) {
      return item_of(name, "points = 10\ncredit = \"share\"",
                     "[item.pictures]\njudge = \"mask\"\nscenes = [" + scenes + "]");
    };
    std::string form = kAsTheyCome;
    form.replace(form.find("{program}"), 9, words);
    const std::string rubric =
        grading.write("rubric.toml", "[driver]\npreset = \"B\"\n" + form +
                                         item("some", "\"full.toml\", \"uneven.toml\"") +
                                         item("none", "\"uneven.toml\""));
    outcome_ = grading.grade(
        rubric, {grading.path("submissions/right"), grading.path("submissions/dull")}, "out", more);
  }
  std::vector<double> points(const std::string& name) const {
    const json result = grading.result(name);
    return {result["score"], result["points"]};
  }

  Outcome outcome_;
};

TEST_F(Unsaid, cases_leave_the_total_and_every_page_says_how_many) {
  const std::string wrapper = grading.write("wrapper/wrap.py", kWrapper);
  fs::permissions(grading.path("wrapper"), fs::perms::owner_all);  // of which others get a copy
  grade("python3 " + wrapper + " {program}");
  EXPECT_EQ(points("right"), (std::vector<double>{10, 10}));
  const json result = grading.result("right");
  EXPECT_EQ(item(result, "some")["unsaid"], 1);
  EXPECT_EQ(item(result, "some")["cases"], 1);
  EXPECT_EQ(item(result, "none")["unsaid"], 1);
  EXPECT_EQ(item(result, "none")["state"], "not asked");
  EXPECT_EQ(item(result, "none")["reason"]["kind"], "cannot be said");
  const std::string kAll = "2 of 3 cases cannot be said in its form";
  expect_parts(grading.file("right", "report.html"),
               {kAll, "; 1 further case cannot be said in its form"});
  expect_parts(contents(grading.path("out/index.html")), {kAll});
  expect_parts(outcome_.out, {kAll});
}

TEST_F(Unsaid, cases_are_never_so_by_the_word_of_whom_is_judged) {
  grade("python3 " + grading.write("wrapper/wrap.py", kWrapper) + " {program}", kLimitsOnly);
  EXPECT_EQ(points("dull"), (std::vector<double>{0, 10})) << "the wrapper passes its code on";
  grade("{program}", kLimitsOnly);
  EXPECT_EQ(points("dull"), (std::vector<double>{0, 20}));
  EXPECT_EQ(points("right"), (std::vector<double>{20, 20}));
  expect_parts(grading.file("dull", "report.html"), {"exited with 77"});
  grade("sh -c 'exec python3 main.py $2 $3' {program}", kLimitsOnly);
  EXPECT_EQ(points("dull"), (std::vector<double>{0, 20})) << "it lies where the command runs";
}

}  // namespace
}  // namespace raycheck::tests
