// Cases that a wrapper's scene format cannot express do not count; only the instructor's wrapper
// can declare them.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// wrap.sh PROGRAM... SCENE IMAGE: a wrapper whose format has only symmetric bounds. It returns its
/// program's exit code.
constexpr const char* kWrapper = R"(while [ $# -gt 2 ]; do program="$program $1"; shift; done
awk '$1 == "bounds" && $2 != -$3 { exit 1 }' "$1" || exit 77
exec $program "$1" "$2"
)";

class Unsaid : public GradingTest {
 protected:
  Unsaid() {
    grading.write("uneven.toml",
                  replaced(contents(grading.path("full.toml")), "right = 1", "right = 2"));
    grading.write("submissions/right/main.py", renderer_in_python());
    // It draws the dry run's scene and declares all other cases inexpressible.
    grading.write("submissions/degenerate/rt.py", renderer_in_python("if h != 25: sys.exit(77)\n"));
    wrapper_ = grading.write("wrapper/wrap.sh", kWrapper);
  }

  /// Grades a submission by a rubric with these words before {scene}.
  void grade(const std::string& name, const std::string& words, const std::string& more = "") {
    const auto item = [](const std::string& called, const std::string& scenes) {
      return item_of(called, "points = 10\ncredit = \"share\"",
                     "[item.pictures]\njudge = \"mask\"\nscenes = [" + scenes + "]");
    };
    std::string form = kAsTheyCome;
    form.replace(form.find("{program}"), 9, words);
    const std::string rubric =
        grading.write("rubric.toml", "[driver]\npreset = \"B\"\n" + form +
                                         item("some", "\"full.toml\", \"uneven.toml\"") +
                                         item("none", "\"uneven.toml\""));
    outcome_ = grading.grade(rubric, {grading.path("submissions/" + name)}, "out", more);
  }
  std::vector<double> points(const std::string& name) const {
    const json result = grading.result(name);
    return {result["score"], result["points"]};
  }

  std::string wrapper_;
  Outcome outcome_;
};

TEST_F(Unsaid, cases_leave_the_total_and_every_page_shows_their_number) {
  fs::permissions(grading.path("wrapper"), fs::perms::owner_all);  // others get a copy
  grade("right", "sh " + wrapper_ + " {program}");
  EXPECT_EQ(points("right"), (std::vector<double>{10, 10}));
  const json result = grading.result("right");
  EXPECT_EQ(item(result, "some")["unsaid"], 1);
  EXPECT_EQ(item(result, "some")["cases"], 1);
  EXPECT_EQ(item(result, "none")["unsaid"], 1);
  EXPECT_EQ(item(result, "none")["state"], "not asked");
  EXPECT_EQ(item(result, "none")["reason"]["kind"], "cannot be said");
  const std::string kAll = "2 of 3 cases cannot be written in the input format of the program";
  expect_parts(grading.file("right", "report.html"),
               {kAll, "; 1 further case cannot be written in the input format of the program"});
  expect_parts(contents(grading.path("out/index.html")), {kAll});
  expect_parts(outcome_.out, {kAll});
}

TEST_F(Unsaid, cases_cannot_be_claimed_by_the_submission) {
  grade("degenerate", "sh " + wrapper_ + " {program}", kLimitsOnly);
  EXPECT_EQ(points("degenerate"), (std::vector<double>{0, 10})) << "the wrapper passes its code on";
  // This holds even if the wrapper is in the folder where the command runs.
  const std::string last_two = "while [ $# -gt 2 ]; do shift; done; exec python3 rt.py $1 $2";
  for (const std::string& words :
       {std::string("{program}"), "sh -c '" + last_two + "' sh {program}"}) {
    grade("degenerate", words, kLimitsOnly);
    EXPECT_EQ(points("degenerate"), (std::vector<double>{0, 20})) << words;
    expect_parts(grading.file("degenerate", "report.html"), {"exited with 77"});
  }
}

}  // namespace
}  // namespace raycheck::tests
