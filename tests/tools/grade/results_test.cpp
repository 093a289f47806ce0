// The files that `grade` writes, as those read them that they are for.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

/// The lecture's rubric with an item hidden and one shown late.
std::string rubric_of(const Grading& grading) {
  return grading.lecture7_with(
      {{"name = \"ray origin\"", "name = \"ray origin\"\nvisibility = \"hidden\""},
       {"name = \"hit point\"", "name = \"hit point\"\nvisibility = \"after_due_date\""}});
}

json results(const Grading& grading, const std::string& name) {
  return json::parse(grading.file(name, "results.json"));
}

json test_named(const json& results, const std::string& name) {
  for (const json& one : results["tests"]) {
    if (one["name"] == name) return one;
  }
  return {};
}

TEST(GradescopeResults, have_the_keys_of_its_specification) {
  const Grading grading;
  const Outcome outcome =
      grading.grade(rubric_of(grading),
                    {grading.submit("right", "rays.py"),
                     grading.submit("wrong", "rays.py", "MISTAKE = \"no_test_for_t\""),
                     grading.submit("broken", "hostile.cpp", "#define ATTACK compile_error")},
                    "out", "--format gradescope");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "3 submissions graded")) << outcome.out;
  const std::vector<std::string> visibilities = {"visible", "hidden", "after_due_date",
                                                 "after_published"};
  for (const char* name : {"right", "wrong", "broken"}) {
    const json all = results(grading, name);
    EXPECT_EQ(all["score"], grading.result(name)["score"]);
    EXPECT_EQ(all["visibility"], "visible");
    EXPECT_EQ(all["stdout_visibility"], "hidden");
    EXPECT_EQ(all["output_format"], "text");
    double sum = 0, most = 0;
    ASSERT_EQ(all["tests"].size(), 10u) << "whole scenes are not asked of programs";
    for (const json& one : all["tests"]) {
      sum += one["score"].get<double>();
      most += one["max_score"].get<double>();
      EXPECT_TRUE(one["status"] == "passed" || one["status"] == "failed");
      EXPECT_TRUE(one["name"].is_string() && one["number"].is_string());
      EXPECT_TRUE(one["output"].is_string());
      EXPECT_NE(std::find(visibilities.begin(), visibilities.end(), one["visibility"]),
                visibilities.end());
    }
    EXPECT_NEAR(sum, all["score"].get<double>(), 1e-9) << name;
    EXPECT_EQ(most, 100) << "without the bonus";
    EXPECT_EQ(test_named(all, "ray origin")["visibility"], "hidden");
    EXPECT_EQ(test_named(all, "hit point")["visibility"], "after_due_date");
    EXPECT_EQ(test_named(all, "nearest root")["visibility"], "visible");
  }
  EXPECT_EQ(results(grading, "right")["score"], 110);
  const json wrong = results(grading, "wrong");
  const json root = test_named(wrong, "nearest root");
  EXPECT_EQ(root["status"], "failed");
  EXPECT_EQ(root["score"], 0);
  EXPECT_EQ(root["max_score"], 10);
  for (const char* part : {"mistake: s >= 0 is not tested", "hint: What does your code do",
                           "the smallest failing case", "[[sphere]]", "  got   ", "  exact miss"}) {
    EXPECT_TRUE(contains(root["output"], part)) << part << "\n" << root["output"];
  }
  EXPECT_EQ(test_named(wrong, "robustness (bonus, 10 points)")["max_score"], 0);
  EXPECT_TRUE(contains(results(grading, "broken")["output"], "this does not compile"));
}

TEST(PrairieLearnResults, have_the_keys_of_its_specification) {
  const Grading grading;
  const Outcome outcome =
      grading.grade(rubric_of(grading),
                    {grading.submit("right", "rays.py"),
                     grading.submit("wrong", "rays.py", "MISTAKE = \"normalize_discarded\""),
                     grading.submit("broken", "hostile.cpp", "#define ATTACK compile_error")},
                    "out", "--format prairielearn");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
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
    EXPECT_EQ(all["tests"].size(), 8u);
    EXPECT_EQ(all["gradable"], std::string(name) != "broken");
  }
  EXPECT_EQ(test_named(results(grading, "wrong"), "unit directions")["points"], 0);
  const json broken = results(grading, "broken");
  EXPECT_EQ(broken["score"], 0);
  ASSERT_EQ(broken["format_errors"].size(), 1u);
  EXPECT_TRUE(contains(broken["format_errors"][0], "this does not compile"));
  EXPECT_FALSE(results(grading, "right").contains("format_errors"));
}

TEST(ClassResults, are_the_same_as_csv_as_json_and_as_files) {
  const Grading grading;
  const std::string odd = "=1+1, \"quoted\"";
  const std::vector<std::string> folders = {
      grading.submit("right", "rays.py"), grading.submit(odd, "rays.py", "MISTAKE = \"mirrored\""),
      grading.submit("broken", "hostile.cpp", "#define ATTACK compile_error")};
  const Outcome csv = grading.grade(kLecture7, folders, "out", "--format csv");
  EXPECT_EQ(csv.exit_code, 0) << csv.err;
  EXPECT_EQ(csv.out, grading.file("", "grades.csv"));
  const std::string reader =
      grading.write("reader.py",
                    "import csv, json, sys\n"
                    "json.dump(list(csv.reader(open(sys.argv[1], newline=''))), sys.stdout)\n");
  const Outcome parsed = run_python("'" + reader + "' '" + grading.path("out/grades.csv") + "'");
  ASSERT_EQ(parsed.exit_code, 0) << parsed.err;
  const json rows = json::parse(parsed.out);
  ASSERT_EQ(rows.size(), 4u);
  for (const json& row : rows) EXPECT_EQ(row.size(), 15u) << row;
  EXPECT_EQ(rows[0][0], "submission");
  EXPECT_EQ(rows[0][5], "pixel (0, 0)");
  EXPECT_EQ(rows[1][1], "110");
  EXPECT_EQ(rows[1][14], "");
  EXPECT_EQ(rows[2][0], "'" + odd) << "no formula";
  EXPECT_EQ(rows[2][14], "columns are mirrored");
  EXPECT_EQ(rows[3][1], "0");
  EXPECT_EQ(rows[3][14], "g++ exited with 1");
  const Outcome as_json = grading.grade(kLecture7, folders, "out", "--format json");
  const json report = json::parse(as_json.out);
  EXPECT_EQ(report["rubric"], "Lecture 7: rays and spheres");
  EXPECT_EQ(report["interrupted"], false);
  ASSERT_EQ(report["submissions"].size(), 3u);
  EXPECT_EQ(report["submissions"][1], grading.result(odd));
}

/// What a page refers to: addresses and sources.
std::vector<std::string> references(const std::string& html) {
  static const std::regex reference(
      "(?:href|src|action|poster|data|srcset)=\"([^\"]*)\"|url\\(([^)]*)\\)|@import|<script");
  std::vector<std::string> found;
  for (std::sregex_iterator at(html.begin(), html.end(), reference), end; at != end; ++at) {
    found.push_back((*at)[1].matched ? (*at)[1].str() : (*at)[0].str());
  }
  return found;
}

TEST(Pages, need_nothing_besides_themselves_and_escape_what_is_the_submissions) {
  const Grading grading;
  const std::string name = "<b>x&\"";
  const std::string escaped = "&lt;b&gt;x&amp;&quot;";
  const Outcome outcome = grading.grade(
      grading.lecture7_with({}),
      {grading.submit(name, "rays.cpp", "#error <script>alert(1)</script> & \"more\""),
       grading.submit_built("wrong", "rays.cpp", "far_root"),
       grading.submit_built("'also <i>wrong", "rays.cpp", "far_root")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string broken = grading.file(name, "report.html");
  const std::string wrong = grading.file("wrong", "report.html");
  const std::string index = grading.file("", "index.html");
  EXPECT_TRUE(contains(broken, "&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;more&quot;"));
  EXPECT_TRUE(contains(broken, "<p>" + escaped + "</p>")) << broken;
  EXPECT_TRUE(contains(broken, "<title>Lecture 7: rays and spheres: " + escaped + "</title>"));
  EXPECT_TRUE(contains(index, escaped));
  for (const std::string& page : {broken, wrong, index}) {
    EXPECT_GT(page.size(), 2000u);
    EXPECT_FALSE(contains(page, "http:"));
    EXPECT_FALSE(contains(page, "https:"));
    EXPECT_FALSE(contains(page, "src="));
    EXPECT_FALSE(contains(page, "<script"));
    EXPECT_FALSE(contains(page, "<b>"));
    EXPECT_FALSE(contains(page, "<i>"));
  }
  EXPECT_TRUE(references(broken).empty());
  EXPECT_GE(references(wrong).size(), 2u);
  for (const std::string& reference : references(wrong)) {
    EXPECT_EQ(reference.rfind("data:text/plain;", 0), 0u) << reference;
  }
  const std::vector<std::string> links = references(index);
  EXPECT_GE(links.size(), 5u) << "those that are alike are linked too";
  for (const std::string& link : links) {
    EXPECT_TRUE(link == "wrong/report.html" || link == "%3Cb%3Ex%26%22/report.html" ||
                link == "%27also%20%3Ci%3Ewrong/report.html")
        << link;
  }
}

TEST(Pages, show_a_case_that_check_takes) {
  const Grading grading;
  const std::string submission = grading.submit_built("wrong", "rays.cpp", "far_root");
  grading.grade(grading.lecture7_with({}), {submission});
  const json failing = item(grading.result("wrong"), "nearest root")["failing"];
  const std::string scene = grading.path("out/wrong/nearest-root.toml");
  EXPECT_TRUE(contains(contents(scene), failing["scene"])) << "with the pixels before it, if any";
  const std::string check = "check '" + scene + "' --candidate 'library:";
  EXPECT_EQ(run(check + submission + "/far_root.so'").exit_code, 1);
  EXPECT_EQ(
      run(check + built_submission("right.cpp", "right", grading.path("right")) + "'").exit_code,
      0);
}

}  // namespace
}  // namespace raycheck::tests
