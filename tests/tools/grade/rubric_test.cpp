// The effect of a rubric's keys on points and students' pages, and the shipped rubrics.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// Grades the submission with this mistake by a rubric of these items.
json graded(const Grading& grading, const std::string& items, const std::string& file,
            const std::string& mistake, const std::string& more = "",
            const std::string& keys = "") {
  const std::string folder = grading.path("submissions/" + mistake);
  if (!fs::exists(folder)) grading.submit_built(mistake, file, mistake);
  grading.grade(grading.short_rubric(keys, items), {folder}, "out", more);
  const json result = grading.result(mistake);
  EXPECT_TRUE(result["refused"].is_null());
  return result;
}

class RubricKeys : public GradingTest {};

TEST_F(RubricKeys, credit_turns_the_share_of_holding_cases_into_points) {
  const std::string nearest = functions("nearest-sphere", "course", 40, kGivenRays);
  const std::string share = "points = 8\ncredit = \"share\"";
  const std::string steps = "points = 8\ncredit = \"steps\"\nsteps = ";
  // The items are tried one at a time, because together the mistake would cost only the first.
  const auto wrong = [&](const std::string& keys) {
    const json result =
        graded(grading, item_of("one", keys, nearest), "rays.cpp", "first_sphere_wins");
    const json one = item(result, "one");
    expect_values(one, {{"state", "fails"}, {"cases", 40}});
    EXPECT_GT(one["held"], 12) << "a share between the steps";
    EXPECT_LT(one["held"], 39);
    EXPECT_EQ(result["points"], 8);
    EXPECT_EQ(result["score"], one["score"]);
    return one;
  };
  EXPECT_EQ(wrong("points = 8")["score"], 0);
  const json shared = wrong(share);
  EXPECT_EQ(shared["score"], shared["held"].get<double>() / 40 * 8);
  EXPECT_EQ(wrong(steps + "[[1, 1], [0.1, 0.25], [0.2, 0.5]]")["score"], 4);
  EXPECT_EQ(wrong(steps + "[[0.99, 0.5], [1, 1]]")["score"], 0);
  const json right =
      graded(grading,
             item_of("all", "points = 8", nearest) + item_of("share", share, nearest) +
                 item_of("steps", "points = 8\ncredit = \"steps\"\nsteps = [[1, 0.5], [0.5, 0.25]]",
                         nearest),
             "rays.cpp", "none");
  EXPECT_EQ(right["score"], 20) << "the last step gives but half";
}

TEST_F(RubricKeys, a_mistake_costs_one_item_and_other_items_follow) {
  const std::string nearest = functions("nearest-sphere", "course", 40, kGivenRays);
  const json result =
      graded(grading,
             item_of("first", "points = 8", nearest) +
                 item_of("second", "points = 4\ncredit = \"share\"", nearest) +
                 item_of("other", "points = 2", functions("class", "course", 40, kGivenRays)),
             "rays.cpp", "first_sphere_wins");
  expect_values(item(result, "first"), {{"state", "fails"}, {"score", 0}});
  const json second = item(result, "second");
  EXPECT_EQ(second["state"], "follows");
  EXPECT_LT(second["held"], second["cases"]);
  EXPECT_EQ(second["score"], 4);
  EXPECT_EQ(second["reason"], json({{"kind", "follows"}, {"item", "first"}}));
  EXPECT_EQ(item(result, "other")["state"], "holds");
  EXPECT_EQ(result["score"], 6);
}

TEST_F(RubricKeys, requires_leaves_out_dependent_items) {
  const std::string hits = functions("class", "course", 40, kGivenRays);
  const json result = graded(
      grading,
      item_of("frame", "points = 1", functions("frame", "course", 9)) +
          item_of("seen", "points = 2", "[item.pictures]\nsources = [\"course\"]\ncases = 2") +
          item_of("hit", "points = 4\nrequires = [\"seen\"]", hits) +
          item_of("after", "points = 8\nrequires = [\"hit\", \"frame\"]", hits) +
          item_of("later", "points = 16\nrequires = [\"after\"]", hits),
      "rays.cpp", "u_flipped");
  EXPECT_EQ(item(result, "frame")["state"], "fails");
  expect_values(item(result, "seen"), {{"state", "not asked"}, {"points", 0}});
  EXPECT_EQ(item(result, "hit")["state"], "holds")
      << "an item that is not asked does not count as a prerequisite";
  expect_values(item(result, "after"),
                {{"state", "left out"},
                 {"reason", json({{"kind", "needs"}, {"item", "frame"}, {"state", "fails"}})}});
  EXPECT_EQ(item(result, "later")["reason"],
            json({{"kind", "needs"}, {"item", "after"}, {"state", "left out"}}));
  const std::string page = grading.file("u_flipped", "report.html");
  expect_parts(page, {"left out: &#39;frame&#39; must have all points first, but fails<",
                      "left out: &#39;after&#39; must have all points first, but is left out<"});
  expect_values(result, {{"score", 4}, {"points", 29}});
}

TEST_F(RubricKeys, tolerance_of_the_item_overrides_that_of_the_rubric) {
  const auto judged = [&](const std::string& tolerance, const std::string& mistake,
                          const std::string& of_rubric = "") {
    const json result = graded(
        grading,
        item_of("directions", "points = 1\n" + tolerance, functions("direction", "course", 20)),
        "rays.cpp", mistake, "", of_rubric);
    EXPECT_GT(result["items"][0]["comparisons"], 50);
    return result["score"].get<double>();
  };
  // A float is off by up to 2^-24, which is 2^29 u.
  EXPECT_EQ(judged("tolerance = { ulp = 1e10 }", "float_directions"), 1);
  EXPECT_EQ(judged("tolerance = { ulp = 1e6 }", "float_directions"), 0);
  EXPECT_EQ(judged("tolerance = { conditioning = 1 }", "float_directions"), 0);
  EXPECT_EQ(judged("tolerance = { conditioning = 1e9 }", "float_directions"), 1);
  EXPECT_EQ(judged("", "float_directions"), 0);
  EXPECT_EQ(judged("", "float_directions", "tolerance = { ulp = 1e10 }\n"), 1);
  EXPECT_EQ(judged("tolerance = { ulp = 1 }", "float_directions", "tolerance = { ulp = 1e10 }\n"),
            0);
  EXPECT_EQ(judged("tolerance = { ulp = 0 }", "none"), 0);
  EXPECT_EQ(judged("tolerance = { conditioning = 1 }", "none"), 1);
}

TEST_F(RubricKeys, judge_mask_ignores_which_sphere_is_shown) {
  const std::string scenes = "\nscenes = [\"lecture7/overlap.toml\"]";
  const auto items =
      item_of("mask", "points = 1", "[item.pictures]\njudge = \"mask\"" + scenes) +
      item_of("spheres", "points = 2\nbonus = true", "[item.pictures]" + scenes) +
      item_of("functions", "points = 4", functions("class", "course", 40, kGivenRays));
  const json wrong = graded(grading, items, "rt.cpp", "by_discriminant");
  EXPECT_EQ(item(wrong, "mask")["state"], "holds") << wrong.dump(2);
  EXPECT_GT(item(wrong, "mask")["comparisons"], 60);
  EXPECT_EQ(item(wrong, "spheres")["state"], "fails");
  EXPECT_EQ(item(wrong, "functions")["reason"]["kind"], "not in pictures");
  EXPECT_EQ(wrong["score"], 1);
  const json right = graded(grading, items, "rt.cpp", "none");
  EXPECT_EQ(right["score"], 3);
  EXPECT_EQ(right["points"], 1) << "a bonus comes on top";
}

/// Texts about withheld items in report.html and results.json; redaction_test.cpp checks numbers.
TEST_F(RubricKeys, detail_and_visibility_withhold_information) {
  for (const char* format : {"gradescope", "prairielearn"}) {
    const auto read = [&](const std::string& keys) {
      graded(grading,
             item_of("the root", "points = 3\nhint = \"a hint\"\n" + keys,
                     functions("nearest-root", "course-behind", 40, kGivenRays)),
             "rays.cpp", "far_root", std::string("--format ") + format);
      return grading.file("far_root", "report.html") +
             json::parse(grading.file("far_root", "results.json")).dump();
    };
    const std::string sentence = "the far root is taken for the near one";
    expect_parts(read(""), {sentence, "a hint", "<dt>exact</dt>", "  exact ", "root, ray "});
    const std::string actual = read("detail = \"actual-only\"");
    expect_parts(actual, {"root, ray ", "<dt>yours</dt>"});
    const std::string nothing = read("detail = \"nothing\"");
    expect_parts(nothing, {"fails 37 of 37 cases"});
    read("visibility = \"hidden\"");
    const std::string hidden = grading.file("far_root", "report.html");
    expect_parts(hidden, {"not shown, but in the score: 1 item.", ">0 of 3<"});
    for (const auto& [text, parts] :
         {std::pair(actual, std::vector{"<dt>exact</dt>", "  exact "}),
          {nothing, {sentence.c_str(), "root, ray ", "[[sphere]]", "%5B%5Bsphere%5D%5D", "data:"}},
          {hidden, {"the root", sentence.c_str(), "root, ray "}}}) {
      for (const char* part : parts) EXPECT_FALSE(has(text, part)) << part;
    }
  }
}

TEST(RubricCommand, prints_a_rubric_that_works_without_its_scenes) {
  const Grading grading;
  const Outcome printed = run("rubric lecture7", 0);
  EXPECT_EQ(printed.out, contents(std::string(RAYCHECK_SOURCE_DIR) + "/" + kLecture7));
  const std::string mine = grading.write("mine.toml", printed.out);
  const Outcome tried = run("grade '" + mine + "'", 0);
  EXPECT_EQ(tried.out, run(std::string("grade ") + kLecture7).out);
  const std::string zip = grading.path("mine.zip");
  EXPECT_EQ(run("grade '" + mine + "' --package '" + zip + "'").exit_code, 0);
  const Outcome names = run_python("-m zipfile -l '" + zip + "'");
  expect_parts(names.out, {"rubric/mine.toml "});
  EXPECT_TRUE(has(names.out, "rubric/lecture7/frame.toml ")) << "scenes are packed";
}

TEST(RubricCommand, copies_a_rubric_with_its_scenes_and_overwrites_nothing) {
  const Grading grading;
  const std::string out = grading.path("copy/of/it");
  const Outcome copied = run("rubric lecture7 --out '" + out + "'", 0);
  const fs::path folder = std::string(RAYCHECK_SOURCE_DIR) + "/examples/rubrics";
  std::size_t scenes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    if (!entry.is_regular_file()) continue;
    const fs::path name = fs::relative(entry.path(), out);
    EXPECT_EQ(contents(entry.path()), contents(folder / name)) << name;
    scenes += name.has_parent_path() ? 1 : 0;
  }
  EXPECT_GE(scenes, 10u);
  EXPECT_EQ(copied.out,
            "wrote " + out + "/lecture7.toml and " + std::to_string(scenes) + " files\n");
  grading.write("copy/of/it/lecture7.toml", "mine");
  const Outcome again = run("rubric lecture7.toml --out '" + out + "'", 2);
  expect_parts(again.err, {"out " + out + ": lecture7", " already exists there"});
  EXPECT_EQ(contents(out + "/lecture7.toml"), "mine");
}

TEST(RubricScenes, beside_the_rubric_are_preferred_to_shipped_scenes) {
  const Grading grading;
  const std::string rubric = grading.short_rubric("", kPixelZeroZero);
  const std::string right = grading.submit_built("right", "rt.cpp", "none");
  grading.grade(rubric, {right});
  EXPECT_EQ(grading.result("right")["score"], 4);
  const std::string beside = grading.write("lecture7/orientation.toml", "no scene");
  expect_parts(grading.grade(rubric, {right}, "out", "", 2).err, {beside});
}

TEST_F(RubricKeys, why_is_printed_with_the_question) {
  const std::string asked = "points = 4\nasks = \"U & V\"\nwhy = \"A <b> left hand\"";
  grading.grade(grading.short_rubric("", item_of("frame", asked, functions("frame", "course", 6))),
                {grading.submit_built("wrong", "rays.cpp", "u_flipped"),
                 grading.submit_built("right", "rays.cpp", "none")},
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
