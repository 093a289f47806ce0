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

constexpr const char* kOdd = "=1+1, \"quoted\"";

void expect_gradescope(const Grading& grading) {
  const std::vector<std::string> visibilities = {"visible", "hidden", "after_due_date",
                                                 "after_published"};
  for (const char* name : {"right", "wrong", "broken"}) {
    const json all = results(grading, name);
    EXPECT_EQ(all["score"], grading.result(name)["score"]);
    EXPECT_EQ(all["visibility"], "visible");
    EXPECT_EQ(all["stdout_visibility"], "hidden");
    EXPECT_EQ(all["output_format"], "text");
    double sum = 0, most = 0;
    ASSERT_EQ(all["tests"].size(), 11u) << "whole scenes are not asked of programs";
    for (const json& one : all["tests"]) {
      sum += one["score"].get<double>();
      most += one["max_score"].get<double>();
      EXPECT_TRUE(one["status"] == "passed" || one["status"] == "failed");
      EXPECT_TRUE(one["name"].is_string() && one["number"].is_string());
      EXPECT_TRUE(one["output"].is_string());
      EXPECT_NE(
          std::find(visibilities.begin(), visibilities.end(), one["visibility"].get<std::string>()),
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
    EXPECT_EQ(all["tests"].size(), 9u);
    EXPECT_EQ(all["gradable"], std::string(name) != "broken");
  }
  EXPECT_EQ(test_named(results(grading, "wrong"), "nearest root")["points"], 0);
  const json broken = results(grading, "broken");
  EXPECT_EQ(broken["score"], 0);
  ASSERT_EQ(broken["format_errors"].size(), 1u);
  EXPECT_TRUE(contains(broken["format_errors"][0], "this does not compile"));
  EXPECT_FALSE(results(grading, "right").contains("format_errors"));
}

void expect_csv(const Grading& grading, const std::string& printed) {
  EXPECT_EQ(printed, grading.file("", "grades.csv"));
  const std::string reader =
      grading.write("reader.py",
                    "import csv, json, sys\n"
                    "json.dump(list(csv.reader(open(sys.argv[1], newline=''))), sys.stdout)\n");
  const Outcome parsed = run_python("'" + reader + "' '" + grading.path("out/grades.csv") + "'");
  ASSERT_EQ(parsed.exit_code, 0) << parsed.err;
  const json rows = json::parse(parsed.out);
  ASSERT_EQ(rows.size(), 5u);
  for (const json& row : rows) EXPECT_EQ(row.size(), 16u) << row;
  EXPECT_EQ(rows[0][0], "submission");
  EXPECT_EQ(rows[0][6], "pixel (0, 0)");
  EXPECT_EQ(rows[1][1], "110");
  EXPECT_EQ(rows[1][15], "");
  EXPECT_EQ(rows[2][0], std::string("'") + kOdd) << "no formula";
  EXPECT_EQ(rows[2][15], "columns are mirrored");
  EXPECT_EQ(rows[3][1], "") << "no points are known";
  EXPECT_EQ(rows[3][5], "");
  EXPECT_EQ(rows[3][15], "could not be judged: g++ exited with 1");
}

TEST(Results, of_a_class_are_what_each_system_reads) {
  const Grading grading;
  const std::string rubric = rubric_of(grading);
  const std::vector<std::string> folders = {
      grading.submit("right", "rays.py"), grading.submit(kOdd, "rays.py", "MISTAKE = \"mirrored\""),
      grading.submit("broken", "hostile.cpp", "#define ATTACK compile_error"),
      grading.submit("wrong", "rays.py", "MISTAKE = \"no_test_for_t\"")};
  const auto graded = [&](const char* format) {
    const Outcome outcome =
        grading.grade(rubric, folders, "out", std::string("--format ") + format);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string printed = graded("gradescope");
  EXPECT_TRUE(contains(printed, "4 submissions graded")) << printed;
  expect_gradescope(grading);
  // The grades are those of the run before: only what is written is another.
  graded("prairielearn");
  expect_prairielearn(grading);
  expect_csv(grading, graded("csv"));
  const json report = json::parse(graded("json"));
  EXPECT_EQ(report["rubric"], "Lecture 7: rays and spheres");
  EXPECT_EQ(report["interrupted"], false);
  EXPECT_EQ(report["reused"], 4);
  ASSERT_EQ(report["submissions"].size(), 4u);
  EXPECT_EQ(report["submissions"][1], grading.result(kOdd));
}

TEST(ClassResults, say_what_the_rubric_gives_for_what_could_not_be_judged) {
  const Grading grading;
  const std::string rubric =
      grading.lecture7_with({{"seconds = 60", "unjudged = 0.25\nseconds = 60"}});
  const std::string broken =
      grading.submit("broken", "hostile.cpp", "#define ATTACK compile_error");
  const std::string right = grading.submit("right", "rays.py");
  const Outcome text = grading.grade(rubric, {broken, right}, "out", "--format gradescope");
  EXPECT_TRUE(contains(text.out, "broken      25 of 100  could not be judged: ")) << text.out;
  EXPECT_TRUE(contains(text.out, "right      110 of 100\n")) << text.out;
  EXPECT_TRUE(contains(text.out, "2 submissions graded, 1 could not be judged")) << text.out;
  EXPECT_EQ(results(grading, "broken")["score"], 25);
  EXPECT_TRUE(contains(results(grading, "broken")["output"], "could not be judged"));
  EXPECT_TRUE(contains(grading.file("", "grades.csv"), "\nbroken,25,100,,,"));
  EXPECT_TRUE(contains(grading.file("", "statistics.csv"), "\nnot judged,,1,,,,\n"));
  EXPECT_TRUE(contains(grading.file("", "index.html"), "gives them 25% of the points"));
  EXPECT_TRUE(contains(grading.file("broken", "report.html"),
                       "could not be judged, for which there are 25 of 100"));
  EXPECT_EQ(grading.result("broken")["score"], 25);
  EXPECT_FALSE(grading.result("broken")["refused"].is_null());
  const Outcome one = grading.grade(rubric, {broken}, "one", "--format prairielearn");
  EXPECT_TRUE(contains(one.out, "broken: 25 of 100, could not be judged: ")) << one.out;
  const json prairielearn = json::parse(grading.file("broken", "results.json", "one"));
  EXPECT_EQ(prairielearn["gradable"], true) << "what is not gradable has no score there";
  EXPECT_EQ(prairielearn["score"], 0.25);
  EXPECT_TRUE(contains(prairielearn["message"], "could not be judged"));
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

/// `check` fails a submission on the case that its page shows, and a right one not.
void expect_case_for_check(const Grading& grading, const std::string& library) {
  const json failing = item(grading.result("wrong"), "nearest root")["failing"];
  const std::string scene = grading.path("out/wrong/nearest-root.toml");
  EXPECT_TRUE(contains(contents(scene), failing["scene"])) << "with the pixels before it, if any";
  const std::string check = "check '" + scene + "' --candidate 'library:";
  EXPECT_EQ(run(check + library + "'").exit_code, 1);
  EXPECT_EQ(
      run(check + built_submission("right.cpp", "right", grading.path("right")) + "'").exit_code,
      0);
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
  EXPECT_GE(references(wrong).size(), 1u);
  for (const std::string& reference : references(wrong)) {
    EXPECT_TRUE(reference.starts_with("data:text/plain;") || reference == "figures.html#finding-1")
        << reference;
  }
  EXPECT_FALSE(grading.file("wrong", "figures.html").empty());
  const std::vector<std::string> links = references(index);
  EXPECT_GE(links.size(), 5u) << "those that are alike are linked too";
  for (const std::string& link : links) {
    EXPECT_TRUE(link.starts_with("data:text/plain;") || link == "wrong/report.html" ||
                link == "wrong/figures.html" || link == "%27also%20%3Ci%3Ewrong/figures.html" ||
                link == "%3Cb%3Ex%26%22/report.html" ||
                link == "%27also%20%3Ci%3Ewrong/report.html")
        << link;
  }
  expect_case_for_check(grading, grading.path("submissions/wrong/far_root.so"));
}

void expect_statistics(const Grading& grading) {
  const std::string table = grading.file("", "statistics.csv");
  EXPECT_EQ(table.find("kind,name,students,full_points,share_full,median_points,points\n"), 0u);
  for (const char* line :
       {"\nitem,camera frame,4,4,1.0000,15,15\n", "\nitem,nearest root,4,2,0.5000,5,10\n",
        "\nitem,\"pixel (0, 0)\",4,3,0.7500,5,5\n", "\nitem,hit or miss,4,4,1.0000,15,15\n",
        "\nmistake,the far root is taken for the near one,2,,,,\n",
        "\nmistake,columns are mirrored,1,,,,\n", "\nnot judged,,1,,,,\n"}) {
    EXPECT_TRUE(contains(table, line)) << line << table;
  }
  for (std::size_t at = 0; at < table.size(); at = table.find('\n', at) + 1) {
    std::size_t commas = 0;
    bool is_quoted = false;
    for (std::size_t k = at; table[k] != '\n'; ++k) {
      is_quoted = is_quoted != (table[k] == '"');
      commas += table[k] == ',' && !is_quoted ? 1 : 0;
    }
    EXPECT_EQ(commas, 6u) << table.substr(at, table.find('\n', at) - at);
  }
}

TEST(ClassResults, rank_mistakes_by_students_and_keep_apart_what_could_not_be_judged) {
  // Two make the same mistake, and one cannot be judged.
  const Grading grading;
  const Outcome outcome =
      grading.grade(grading.lecture7_with({}),
                    {grading.submit_built("ada", "rays.cpp", "none"),
                     grading.submit_built("bob", "rays.cpp", "far_root"),
                     grading.submit_built("cleo", "rt.cpp", "mirrored"),
                     grading.submit("dan", "hostile.cpp", "#define ATTACK compile_error"),
                     grading.submit_built("eve", "rays.cpp", "far_root")});
  EXPECT_EQ(outcome.exit_code, 0);
  expect_statistics(grading);
  EXPECT_TRUE(contains(outcome.out, "could not be judged: g++ exited with 1\n")) << outcome.out;
  EXPECT_TRUE(contains(outcome.out, "5 submissions graded, 1 could not be judged (built in "))
      << outcome.out;
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
  EXPECT_TRUE(contains(of_far_root, "bob/report.html") && contains(of_far_root, "eve/report.html"));
  EXPECT_TRUE(contains(of_far_root, "download=\"nearest-root.toml\""));
  const std::string of_mirrored = page.substr(second, page.find("<h2>Alike</h2>") - second);
  EXPECT_TRUE(contains(of_mirrored, "mirrored left to right\"")) << "its pictures";
  EXPECT_TRUE(contains(of_mirrored, ".txt\" href=\"data:text/plain"));
  EXPECT_TRUE(contains(page, "That proves no copying"));
  const std::size_t apart = page.find("<h2>Could not be judged</h2>");
  ASSERT_NE(apart, std::string::npos);
  EXPECT_LT(apart, page.find("dan/report.html"));
  EXPECT_TRUE(
      std::regex_search(page, std::regex("<p>5 submissions, median [0-9]+%, 1 could not be judged; "
                                         "built in [0-9.]+ s, judged in [0-9.]+ s</p>")))
      << page.substr(0, page.find("<h2>"));
  EXPECT_TRUE(contains(grading.file("dan", "report.html"), ">could not be judged<"));
}

}  // namespace
}  // namespace raycheck::tests
