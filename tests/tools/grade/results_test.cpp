// The files that `grade` writes, read as their users read them.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// 34 points for functions, a hidden item, an item shown late, a bonus of 10, and an item for
/// renderers only.
std::string rubric_of(const Grading& grading) {
  return grading.short_rubric(
      "", item_of("ray origin", "points = 10\nvisibility = \"hidden\"",
                  functions("ray-origin", "course", 6)) +
              item_of("hit point", "points = 10\nvisibility = \"after_due_date\"",
                      functions("hit-point", "course", 6, kGivenRays)) +
              kNearestRoot + kPixelZeroZero +
              item_of("whole scenes", "points = 10",
                      "[item.pictures]\nsources = [\"course\"]\ncases = 1") +
              item_of("robustness", "points = 10\nbonus = true\ntolerance = { conditioning = 16 }",
                      functions("parameter", "distance@4", 6, kGivenRays)));
}

json results(const Grading& grading, const std::string& name) {
  return json::parse(grading.file(name, "results.json"));
}

json test_named(const json& results, const std::string& name) {
  return found(results["tests"], "name", name);
}

constexpr const char* kOdd = "=1+1, \"quoted\"";

void expect_gradescope(const Grading& grading) {
  for (const char* name : {"right", "wrong", "broken"}) {
    const json all = results(grading, name);
    EXPECT_EQ(all["score"], grading.result(name)["score"]);
    expect_values(
        all,
        {{"visibility", "visible"}, {"stdout_visibility", "hidden"}, {"output_format", "text"}});
    double sum = 0, most = 0;
    ASSERT_EQ(all["tests"].size(), 5u) << "programs are not judged on whole scenes";
    for (const json& one : all["tests"]) {
      sum += one["score"].get<double>();
      most += one["max_score"].get<double>();
      EXPECT_TRUE(one["status"] == "passed" || one["status"] == "failed");
      for (const char* key : {"name", "number", "output", "visibility"}) {
        EXPECT_TRUE(one[key].is_string()) << key;
      }
    }
    EXPECT_NEAR(sum, all["score"].get<double>(), 1e-9) << name;
    EXPECT_EQ(most, 34) << "without the bonus";
    EXPECT_EQ(test_named(all, "ray origin")["visibility"], "hidden");
    EXPECT_EQ(test_named(all, "hit point")["visibility"], "after_due_date");
    EXPECT_EQ(test_named(all, "nearest root")["visibility"], "visible");
  }
  EXPECT_EQ(results(grading, "right")["score"], 44);
  const json wrong = results(grading, "wrong");
  const json root = test_named(wrong, "nearest root");
  expect_values(root, {{"status", "failed"}, {"score", 0}, {"max_score", 10}});
  expect_parts(root["output"],
               {"mistake: s >= 0 is not tested", "hint: What does your code do",
                "the smallest failing case", "[[sphere]]", "  got   ", "  exact miss"});
  EXPECT_EQ(test_named(wrong, "robustness (bonus, 10 points)")["max_score"], 0);
  expect_parts(results(grading, "broken")["output"], {"this does not compile"});
}

void expect_prairielearn(const Grading& grading) {
  for (const char* name : {"right", "wrong", "broken"}) {
    const json all = results(grading, name);
    EXPECT_GE(all["score"], 0);
    EXPECT_LE(all["score"], 1) << name << ": at most 1, with any bonus";
    for (const json& one : all["tests"]) {
      EXPECT_NE(one["name"], "ray origin");
      EXPECT_NE(one["name"], "hit point");
      EXPECT_TRUE(one["points"].is_number() && one["max_points"].is_number());
      EXPECT_TRUE(one["message"].is_string() && one["output"].is_string());
    }
    EXPECT_EQ(all["tests"].size(), 3u);
    EXPECT_EQ(all["gradable"], std::string(name) != "broken");
  }
  EXPECT_EQ(test_named(results(grading, "wrong"), "nearest root")["points"], 0);
  const json broken = results(grading, "broken");
  EXPECT_EQ(broken["score"], 0);
  ASSERT_EQ(broken["format_errors"].size(), 1u);
  expect_parts(broken["format_errors"][0], {"this does not compile"});
  EXPECT_FALSE(results(grading, "right").contains("format_errors"));
}

TEST(Results, of_a_class_have_the_format_of_each_system) {
  const Grading grading;
  const std::string rubric = rubric_of(grading);
  const std::vector<std::string> folders = {
      grading.submit_built("right", "rays.cpp", "none"),
      grading.submit_built(kOdd, "rays.cpp", "mirrored"), grading.submit_broken("broken"),
      grading.submit_built("wrong", "rays.cpp", "no_test_for_t")};
  const auto graded = [&](const char* format) {
    return grading.grade(rubric, folders, "out", std::string("--format ") + format).out;
  };
  const std::string printed = graded("gradescope");
  expect_parts(printed, {"3 of 4 submissions graded; 1 could not be judged"});
  expect_gradescope(grading);
  // The grades are those of the previous run; only the format of the files differs.
  graded("prairielearn");
  expect_prairielearn(grading);
  const std::string table = graded("csv");
  EXPECT_EQ(table, grading.file("", "grades.csv"));
  expect_parts(table, {"\nright,44,", "\n\"'=1+1, \"\"quoted\"\"\",", ",columns are mirrored\n",
                       "\nbroken,,34,", ",could not be judged: g++ exited with 1\n"});
  const json report = json::parse(graded("json"));
  expect_values(report, {{"rubric", "A rubric"}, {"interrupted", false}});
  ASSERT_EQ(report["submissions"].size(), 4u);
  EXPECT_EQ(report["submissions"][1], grading.result(kOdd));
}

TEST(ClassResults, show_the_points_for_submissions_that_could_not_be_judged) {
  const Grading grading;
  const std::string hits = functions("class", "course", 6, kGivenRays);
  const std::string rubric = grading.short_rubric(
      "unjudged = 0.25\n",
      item_of("hits", "points = 100", hits) + item_of("more", "points = 10\nbonus = true", hits));
  const std::string broken = grading.submit_broken("broken");
  const std::string right = grading.submit_built("right", "rays.cpp", "none");
  expect_parts(grading.grade(rubric, {broken, right}, "out", "--format gradescope").out,
               {"broken      25 of 100  could not be judged: ", "right      100 of 100, bonus 10\n",
                "1 of 2 submissions graded; 1 could not be judged"});
  EXPECT_EQ(results(grading, "broken")["score"], 25);
  expect_parts(results(grading, "broken")["output"], {"could not be judged"});
  expect_parts(grading.file("", "grades.csv"), {"\nbroken,25,100,,,"});
  expect_parts(grading.file("", "index.html"), {"gives them 25% of the points"});
  expect_parts(grading.file("broken", "report.html"),
               {"could not be judged; such a submission gets 25 of 100"});
  EXPECT_EQ(grading.result("broken")["score"], 25);
  EXPECT_FALSE(grading.result("broken")["refused"].is_null());
  const Outcome one = grading.grade(rubric, {broken}, "one", "--format prairielearn");
  expect_parts(one.out, {"broken: 25 of 100, could not be judged: "});
  const json prairielearn = json::parse(grading.file("broken", "results.json", "one"));
  EXPECT_EQ(prairielearn["gradable"], true) << "what is not gradable has no score there";
  EXPECT_EQ(prairielearn["score"], 0.25);
  expect_parts(prairielearn["message"], {"could not be judged"});
}

/// The references of a page: addresses and sources.
std::vector<std::string> references(const std::string& html) {
  static const std::regex reference(
      "(?:href|src|action|poster|data|srcset)=\"([^\"]*)\"|url\\(([^)]*)\\)|@import|<script");
  std::vector<std::string> found;
  for (std::sregex_iterator at(html.begin(), html.end(), reference), end; at != end; ++at) {
    found.push_back((*at)[1].matched ? (*at)[1].str() : (*at)[0].str());
  }
  return found;
}

/// Expects that `check` finds a defect of a submission on the case that its page shows, and no
/// defect of a right one.
void expect_case_for_check(const Grading& grading, const std::string& library) {
  const json failing = item(grading.result("wrong"), "nearest root")["failing"];
  const std::string scene = grading.path("out/wrong/nearest-root.toml");
  EXPECT_TRUE(has(contents(scene), failing["scene"])) << "with the pixels before it, if any";
  const std::string check = "check '" + scene + "' --candidate 'library:";
  EXPECT_EQ(run(check + library + "'").exit_code, 1);
  EXPECT_EQ(
      run(check + built_submission("right.cpp", "right", grading.path("right")) + "'").exit_code,
      0);
}

TEST(Pages, are_self_contained_and_escape_the_submissions_text) {
  const Grading grading;
  const std::string name = "<b>x&\"";
  const std::string escaped = "&lt;b&gt;x&amp;&quot;";
  grading.grade(grading.short_rubric("", kNearestRoot),
                {grading.submit(name, "rays.cpp", "#error <script>alert(1)</script> & \"more\""),
                 grading.submit_built("wrong", "rays.cpp", "far_root"),
                 grading.submit_built("'also <i>wrong", "rays.cpp", "far_root")});
  const std::string broken = grading.file(name, "report.html");
  const std::string wrong = grading.file("wrong", "report.html");
  const std::string index = grading.file("", "index.html");
  expect_parts(broken, {"&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;more&quot;",
                        "<p>" + escaped + "</p>", "<title>A rubric: " + escaped + "</title>"});
  expect_parts(index, {escaped});
  for (const std::string& page : {broken, wrong, index}) {
    EXPECT_GT(page.size(), 2000u);
    for (const char* part : {"http:", "https:", "src=", "<script", "<b>", "<i>"}) {
      EXPECT_FALSE(has(page, part)) << part;
    }
  }
  EXPECT_TRUE(references(broken).empty());
  EXPECT_GE(references(wrong).size(), 1u);
  for (const std::string& reference : references(wrong)) {
    EXPECT_TRUE(reference.starts_with("data:text/plain;") || reference == "figures.html#finding-1")
        << reference;
  }
  EXPECT_FALSE(grading.file("wrong", "figures.html").empty());
  const std::set<std::string> pages = {
      "wrong/report.html", "wrong/figures.html", "%3Cb%3Ex%26%22/report.html",
      "%27also%20%3Ci%3Ewrong/report.html", "%27also%20%3Ci%3Ewrong/figures.html"};
  std::set<std::string> linked;
  for (const std::string& link : references(index)) {
    if (!link.starts_with("data:text/plain;")) linked.insert(link);
  }
  EXPECT_EQ(linked, pages);
  expect_case_for_check(grading, grading.path("submissions/wrong/far_root.so"));
}

TEST(ClassResults, rank_mistakes_by_students_and_separate_unjudged_submissions) {
  // Two submissions make the same mistake, and one cannot be judged.
  const Grading grading;
  const Outcome outcome = grading.grade(
      grading.short_rubric("", kNearestRoot + kPixelZeroZero),
      {grading.submit_built("ada", "rays.cpp", "none"),
       grading.submit_built("bob", "rays.cpp", "far_root"),
       grading.submit_built("cleo", "rt.cpp", "mirrored"), grading.submit_broken("dan"),
       grading.submit_built("eve", "rays.cpp", "far_root")});
  expect_parts(outcome.out, {"could not be judged: g++ exited with 1\n", "/dan/report.html\n",
                             "4 of 5 submissions graded; 1 could not be judged (built in "});
  const std::string page = grading.file("", "index.html");
  const std::size_t first = page.find(
      "<span class=\"name\">the far root is taken for the near one"
      "</span><span>2 of 4 students</span>");
  const std::size_t second =
      page.find("<span class=\"name\">columns are mirrored</span><span>1 of 4 students</span>");
  ASSERT_NE(first, std::string::npos);
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(first, second);
  const std::string of_far_root = page.substr(first, second - first);
  expect_parts(of_far_root,
               {"bob/report.html", "eve/report.html", "download=\"nearest-root.toml\""});
  const std::string of_mirrored =
      page.substr(second, page.find("<h2>Could not be judged</h2>") - second);
  expect_parts(of_mirrored, {".txt\" href=\"data:text/plain"});
  const std::size_t apart = page.find("<h2>Could not be judged</h2>");
  ASSERT_NE(apart, std::string::npos);
  EXPECT_LT(apart, page.find("dan/report.html"));
  EXPECT_TRUE(
      std::regex_search(page, std::regex("<p>5 submissions, median [0-9]+%, 1 could not be judged; "
                                         "built in [0-9.]+ s, judged in [0-9.]+ s</p>")))
      << page.substr(0, page.find("<h2>"));
  expect_parts(grading.file("dan", "report.html"), {">could not be judged<"});
}

}  // namespace
}  // namespace raycheck::tests
