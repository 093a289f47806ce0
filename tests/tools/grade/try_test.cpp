// `try` says what `grade` says.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

/// The files of a folder that students are given.
std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name != "result.json") files[name] = contents(entry.path());
  }
  return files;
}

Outcome try_it(const Grading& grading, const std::string& rubric, const std::string& submission,
               const std::string& more = "") {
  return run("try '" + rubric + "' '" + submission + "' --out '" + grading.path("tried") + "' " +
             more);
}

/// The lines of `text` between the title and the first empty line, or what follows the items.
std::vector<std::string> item_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line) && !line.empty() && !line.starts_with("see ") &&
         !line.starts_with("written: ") && !has(line, " in the score and not shown")) {
    const bool is_of_items = !line.starts_with("isolated by: ") && !has(line, " submission graded");
    if (is_of_items) lines.push_back(line);
  }
  return lines;
}

TEST(TryCommand, agrees_with_grade_in_every_file_and_line) {
  const Grading grading;
  const std::string rubric = grading.lecture7_with({});
  const std::vector<std::string> submissions = {
      grading.submit("right", "rays.py"), grading.submit_built("far", "rays.cpp", "far_root"),
      grading.submit_built("mirrored", "rt.cpp", "mirrored"),
      grading.submit_built("crashing", "hostile.cpp", "crashes"),
      grading.submit("broken", "rt.cpp", "#error this does not compile")};
  for (const std::string& submission : submissions) {
    const std::string name = fs::path(submission).filename();
    const Outcome graded = grading.grade(rubric, {submission});
    const Outcome tried = try_it(grading, rubric, submission);
    EXPECT_EQ(tried.exit_code, name == "right" ? 0 : 1) << tried.err;
    const auto lines = item_lines(tried.out);
    EXPECT_EQ(lines, item_lines(graded.out)) << name;
    EXPECT_GE(lines.size(), name == "broken" ? 2u : 12u);
    const auto files = files_of(grading.path("tried/" + name));
    EXPECT_EQ(files, files_of(grading.path("out/" + name))) << name;
    EXPECT_TRUE(files.contains("report.html"));
  }
}

TEST(TryCommand, shows_what_students_may_see_and_counts_all) {
  const Grading grading;
  const std::string rubric = grading.lecture7_with(
      {{"name = \"camera frame\"", "name = \"camera frame\"\nvisibility = \"hidden\""},
       {"name = \"nearest root\"", "name = \"nearest root\"\ndetail = \"nothing\""}});
  const std::string submission = grading.submit("mine", "rays.py", "MISTAKE = \"no_test_for_t\"");
  const Outcome graded = grading.grade(rubric, {submission});
  const Outcome tried = try_it(grading, rubric, submission);
  EXPECT_FALSE(has(tried.out, "camera frame")) << tried.out;
  expect_parts(tried.out, {"\n  1 item is in the score and not shown\n"});
  const std::size_t at = tried.out.find("\nnearest root\n");
  ASSERT_NE(at, std::string::npos) << tried.out;
  const std::string told = tried.out.substr(at, tried.out.find("\n\n", at) - at);
  expect_parts(told, {"hint: "});
  for (const char* part : {"mistake", "[[sphere]]", "got", "the law"}) {
    EXPECT_FALSE(has(told, part)) << told;
  }
  EXPECT_EQ(item_lines(tried.out).front(), item_lines(graded.out).front()) << "the same score";
  EXPECT_EQ(files_of(grading.path("tried/mine")), files_of(grading.path("out/mine")));
}

TEST(TryCommand, fails_with_2_and_writes_nothing) {
  const Grading grading;
  const std::string mine = grading.submit("mine", "rays.py");
  const auto fails = [&](const std::string& words, const std::string& why) {
    const Outcome outcome = run("try " + words);
    EXPECT_EQ(outcome.exit_code, 2) << words;
    expect_parts(outcome.err, {why});
    EXPECT_EQ(outcome.out, "") << words;
  };
  const std::string rubric = kLecture7;
  fails(rubric, "SUBMISSION");
  fails("nowhere.toml '" + mine + "'", "nowhere.toml: cannot be read");
  fails(rubric + " nowhere", "nowhere: there is no such file or folder");
}

}  // namespace
}  // namespace raycheck::tests
