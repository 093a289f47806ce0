// The rubrics that come with raycheck: listed, printed, copied, and used far from their scenes.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

TEST(RubricCommand, prints_one_that_works_without_its_scenes_beside_it) {
  const Grading grading;
  const Outcome printed = run("rubric lecture7");
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_EQ(printed.out, contents(std::string(RAYCHECK_SOURCE_DIR) + "/" + kLecture7));
  const std::string mine = grading.write("mine.toml", printed.out);
  const Outcome tried = run("grade '" + mine + "'");
  EXPECT_EQ(tried.exit_code, 0) << tried.err;
  EXPECT_EQ(tried.out, run(std::string("grade ") + kLecture7).out);
  const std::string zip = grading.path("mine.zip");
  EXPECT_EQ(run("grade '" + mine + "' --package '" + zip + "'").exit_code, 0);
  const Outcome names = run_python("-m zipfile -l '" + zip + "'");
  expect_parts(names.out, {"rubric/mine.toml "});
  EXPECT_TRUE(has(names.out, "rubric/lecture7/frame.toml ")) << "scenes are packed";
}

TEST(RubricCommand, copies_one_with_its_scenes_and_writes_over_nothing) {
  const Grading grading;
  const std::string out = grading.path("copy/of/it");
  const Outcome copied = run("rubric lecture7 --out '" + out + "'");
  EXPECT_EQ(copied.exit_code, 0) << copied.err;
  const fs::path folder = std::string(RAYCHECK_SOURCE_DIR) + "/tools/grade/rubrics";
  std::size_t scenes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    if (!entry.is_regular_file()) continue;
    const fs::path name = fs::relative(entry.path(), out);
    EXPECT_EQ(contents(entry.path()), contents(folder / name)) << name;
    scenes += name.has_parent_path() ? 1 : 0;
  }
  EXPECT_GE(scenes, 10u);
  EXPECT_EQ(copied.out,
            "wrote " + out + "/lecture7.toml and " + std::to_string(scenes) + " scenes\n");
  grading.write("copy/of/it/lecture7.toml", "mine");
  const Outcome again = run("rubric lecture7.toml --out '" + out + "'");
  EXPECT_EQ(again.exit_code, 2);
  expect_parts(again.err, {"out " + out + ": lecture7", " is there already"});
  EXPECT_EQ(contents(out + "/lecture7.toml"), "mine");
}

TEST(RubricCommand, fails_with_2_and_the_names_there_are) {
  for (const auto& [words, why] :
       {std::pair("lecture8",
                  "rubric lecture8: none of that name comes with raycheck; there is lecture7"),
        {"lecture7/frame", "rubric lecture7/frame: none of that name"},
        {"--out somewhere", "--out: name the rubric to copy"}}) {
    const Outcome outcome = run("rubric " + std::string(words));
    EXPECT_EQ(outcome.exit_code, 2) << words;
    expect_parts(outcome.err, {why});
    EXPECT_EQ(outcome.out, "");
  }
}

constexpr const char* kOneScene = R"(
[[item]]
name = "frame"
points = 4
[item.pictures]
judge = "mask"
scenes = ["lecture7/frame.toml"]
)";

TEST(RubricScenes, lie_beside_the_rubric_before_they_are_those_that_come_with_raycheck) {
  const Grading grading;
  const std::string rubric = grading.write("mine.toml", kFormsOfBuilt + std::string(kOneScene));
  const std::string right = grading.submit_built("right", "rt.cpp", "none");
  const auto keys = [&] {
    grading.grade(rubric, {right});
    return std::pair(grading.result("right")["key"], grading.result("right")["score"]);
  };
  const auto shipped = keys();
  EXPECT_EQ(shipped.second, 4);
  const std::string scene =
      contents(std::string(RAYCHECK_SOURCE_DIR) + "/tools/grade/rubrics/lecture7/frame.toml");
  grading.write("lecture7/frame.toml", scene);
  EXPECT_EQ(keys(), shipped) << "the same scene";
  grading.write("lecture7/frame.toml", scene + "\n# changed\n");
  EXPECT_NE(keys().first, shipped.first) << "the digest is that of the scene beside the rubric";
}

TEST(RubricKeys, why_is_said_beside_what_is_asked) {
  const Grading grading;
  std::string text = kFormsOfBuilt + std::string(kOneScene);
  text.replace(text.find("points"), 6, "asks = \"U & V\"\nwhy = \"A <b> left hand\"\npoints");
  grading.grade(grading.write("mine.toml", text),
                {grading.submit_built("wrong", "rt.cpp", "u_flipped"),
                 grading.submit_built("right", "rt.cpp", "none")},
                "out", "--format prairielearn");
  for (const std::string& page :
       {grading.file("wrong", "report.html"), grading.file("right", "report.html"),
        grading.file("", "index.html")}) {
    expect_parts(page, {"U &amp; V<", "A &lt;b&gt; left hand<"});
  }
  expect_parts(grading.file("right", "results.json"), {R"(asked: U & V\nwhy: A <b> left hand\n)"});
}

}  // namespace
}  // namespace raycheck::tests
