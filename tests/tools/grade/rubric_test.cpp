// What a rubric's keys do to the points, and to what students see.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

constexpr const char* kForms = R"(title = "A rubric"
[conventions]
samples = "edges"
origin = "pixel"
[[form]]
has = "rays.py"
candidate = "command:python3 {file}"
)";

std::string item_of(const std::string& name, const std::string& keys,
                    const std::string& questions) {
  return "[[item]]\nname = \"" + name + "\"\n" + keys + "\n" + questions + "\n";
}

std::string functions(const std::string& law, const std::string& sources = "\"course\"") {
  return "[item.functions]\nlaws = [\"" + law + "\"]\nsources = [" + sources +
         "]\ncases = 40\nrays = \"given\"";
}

/// Graded by a rubric of these items.
json graded(const Grading& grading, const std::string& items, const std::string& file,
            const std::string& mistake, const std::string& more = "") {
  const std::string rubric = grading.write("rubric.toml", kForms + (kFormsOfBuilt + items));
  const std::string submission = file == "rays.py"
                                     ? grading.submit("mine", file, mistake_line(file, mistake))
                                     : grading.submit_built("mine-" + mistake, file, mistake);
  const Outcome outcome = grading.grade(rubric, {submission}, "out", more);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = grading.result(std::filesystem::path(submission).filename());
  EXPECT_TRUE(result["refused"].is_null());
  return result;
}

TEST(RubricKeys, credit_makes_points_of_the_share_of_the_cases_that_hold) {
  const Grading grading;
  const std::string nearest = functions("nearest-sphere");
  const std::string share = "points = 8\ncredit = \"share\"";
  const std::string steps = "points = 8\ncredit = \"steps\"\nsteps = ";
  // Each alone: several would have one mistake cost the first of them only.
  const auto wrong = [&](const std::string& keys) {
    const json result =
        graded(grading, item_of("one", keys, nearest), "rays.py", "first_sphere_wins");
    const json one = item(result, "one");
    EXPECT_EQ(one["state"], "fails");
    EXPECT_EQ(one["cases"], 40);
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
             "rays.py", "none");
  EXPECT_EQ(right["score"], 20) << "the last step gives but half";
}

TEST(RubricKeys, a_mistake_costs_one_item_and_the_others_follow) {
  const Grading grading;
  const std::string nearest = functions("nearest-sphere");
  const json result = graded(grading,
                             item_of("first", "points = 8", nearest) +
                                 item_of("second", "points = 4\ncredit = \"share\"", nearest) +
                                 item_of("other", "points = 2", functions("class")),
                             "rays.py", "first_sphere_wins");
  EXPECT_EQ(item(result, "first")["state"], "fails");
  EXPECT_EQ(item(result, "first")["score"], 0);
  const json second = item(result, "second");
  EXPECT_EQ(second["state"], "follows");
  EXPECT_LT(second["held"], second["cases"]);
  EXPECT_EQ(second["score"], 4);
  EXPECT_EQ(second["reason"], json({{"kind", "follows"}, {"item", "first"}}));
  EXPECT_EQ(item(result, "other")["state"], "holds");
  EXPECT_EQ(result["score"], 6);
}

TEST(RubricKeys, requires_leaves_out_what_cannot_be_right) {
  const Grading grading;
  const std::string frame = functions("frame"), direction = functions("direction");
  const std::string own = "[item.functions]\nlaws = [\"frame\"]\nsources = [\"course\"]\ncases = 9";
  const std::string image = "[item.pictures]\nsources = [\"course\"]\ncases = 2";
  const json result = graded(
      grading,
      item_of("frame", "points = 1", own) + item_of("seen", "points = 2", image) +
          item_of("hit", "points = 4\nrequires = [\"seen\"]", functions("class")) +
          item_of("after", "points = 8\nrequires = [\"hit\", \"frame\"]", functions("class")) +
          item_of("later", "points = 16\nrequires = [\"after\"]", functions("class")),
      "rays.py", "u_flipped");
  EXPECT_EQ(item(result, "frame")["state"], "fails");
  EXPECT_EQ(item(result, "seen")["state"], "not asked");
  EXPECT_EQ(item(result, "seen")["points"], 0);
  EXPECT_EQ(item(result, "hit")["state"], "holds") << "what is not asked holds nobody up";
  EXPECT_EQ(item(result, "after")["state"], "left out");
  EXPECT_EQ(item(result, "after")["reason"],
            json({{"kind", "needs"}, {"item", "frame"}, {"state", "fails"}}));
  EXPECT_EQ(item(result, "later")["reason"],
            json({{"kind", "needs"}, {"item", "after"}, {"state", "left out"}}));
  const std::string page = grading.file("mine", "report.html");
  EXPECT_TRUE(contains(page, "left out: it needs &#39;frame&#39;, which fails<"));
  EXPECT_TRUE(contains(page, "left out: it needs &#39;after&#39;, which is left out<"));
  EXPECT_EQ(result["score"], 4);
  EXPECT_EQ(result["points"], 29);
}

TEST(RubricKeys, tolerance_decides_what_floats_are_worth) {
  const Grading grading;
  const auto judged = [&](const std::string& tolerance, const std::string& mistake) {
    const json result = graded(
        grading,
        item_of("directions", "points = 1\n" + tolerance,
                "[item.functions]\nlaws = [\"direction\"]\nsources = [\"course\"]\ncases = 20"),
        "rays.py", mistake);
    EXPECT_GT(result["items"][0]["comparisons"], 50);
    return result["score"].get<double>();
  };
  // A float is off by up to 2^-24, which is 2^29 u.
  EXPECT_EQ(judged("tolerance = { ulp = 1e10 }", "float_directions"), 1);
  EXPECT_EQ(judged("tolerance = { ulp = 1e6 }", "float_directions"), 0);
  EXPECT_EQ(judged("tolerance = { conditioning = 1 }", "float_directions"), 0);
  EXPECT_EQ(judged("tolerance = { conditioning = 1e9 }", "float_directions"), 1);
  EXPECT_EQ(judged("", "float_directions"), 0);
  EXPECT_EQ(judged("tolerance = { ulp = 0 }", "none"), 0);
  EXPECT_EQ(judged("tolerance = { conditioning = 1 }", "none"), 1);
}

TEST(RubricKeys, tolerance_of_the_rubric_holds_where_an_item_has_none) {
  const Grading grading;
  const std::string questions =
      "[item.functions]\nlaws = [\"direction\"]\nsources = [\"course\"]\ncases = 20";
  const json result =
      graded(grading,
             "[tolerance]\nulp = 1e10\n" + item_of("rubric", "points = 1", questions) +
                 item_of("own", "points = 2\ntolerance = { ulp = 1 }", questions),
             "rays.py", "float_directions");
  EXPECT_EQ(items_that(result, "holds"), std::vector<std::string>{"rubric"});
  EXPECT_EQ(result["score"], 1);
}

TEST(RubricKeys, judge_mask_counts_whether_a_sphere_is_seen_and_not_which) {
  const Grading grading;
  grading.lecture7_with({});
  const std::string scenes = "\nscenes = [\"rubrics/lecture7/overlap.toml\"]";
  const auto items = item_of("mask", "points = 1", "[item.pictures]\njudge = \"mask\"" + scenes) +
                     item_of("spheres", "points = 2\nbonus = true", "[item.pictures]" + scenes) +
                     item_of("functions", "points = 4", functions("class"));
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

/// As pages have a number of a record: "2 (0x1p+1)".
std::string number_text(const json& hexfloat) {
  const std::string hex = hexfloat;
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.17g", std::strtod(hex.c_str(), nullptr));
  return digits.data() + (" (" + hex + ")");
}

/// What students read in report.html and results.json.
struct Read {
  json result;
  std::string text;
};

Read read(const Grading& grading, const std::string& keys, const std::string& format) {
  Read read;
  read.result = graded(grading,
                       item_of("the root", "points = 3\nhint = \"a hint\"\n" + keys,
                               functions("nearest-root", "\"course-behind\"")),
                       "rays.py", "far_root", "--format " + format);
  read.text = grading.file("mine", "report.html") +
              json::parse(grading.file("mine", "results.json")).dump();
  EXPECT_TRUE(read.result["items"][0]["failing"].is_object());
  return read;
}

TEST(RubricKeys, detail_and_visibility_withhold_what_they_say) {
  const Grading grading;
  for (const char* format : {"gradescope", "prairielearn"}) {
    const Read full = read(grading, "", format);
    const json answer = full.result["items"][0]["failing"]["answer"];
    const std::string exact = number_text(answer["exact"][0]), got = number_text(answer["got"][0]);
    const std::string what =
        answer["quantity"].get<std::string>() + ", ray " + answer["ray"].dump();
    const std::string sentence = "the far root is taken for the near one";
    ASSERT_FALSE(exact.empty());
    for (const std::string& part : {exact, got, what, sentence, std::string("a hint")}) {
      EXPECT_TRUE(contains(full.text, part)) << part;
    }
    const Read actual = read(grading, "detail = \"actual-only\"", format);
    EXPECT_EQ(actual.result["items"][0]["failing"]["answer"], answer);
    EXPECT_TRUE(contains(actual.text, got));
    EXPECT_TRUE(contains(actual.text, what));
    EXPECT_FALSE(contains(actual.text, exact));
    EXPECT_FALSE(contains(actual.text, exact.substr(0, exact.find(' ')) + " ")) << exact;
    EXPECT_FALSE(contains(actual.text, "<dt>exact</dt>"));
    EXPECT_FALSE(contains(actual.text, "  exact "));
    const Read nothing = read(grading, "detail = \"nothing\"", format);
    for (const std::string& part : {exact, got, what, sentence, std::string("[[sphere]]"),
                                    std::string("%5B%5Bsphere%5D%5D"), std::string("data:")}) {
      EXPECT_FALSE(contains(nothing.text, part)) << part;
    }
    EXPECT_TRUE(contains(nothing.text, "fails 37 of 37 cases")) << nothing.text;
    const Read hidden = read(grading, "visibility = \"hidden\"", format);
    const std::string page = grading.file("mine", "report.html");
    for (const std::string& part : {std::string("the root"), exact, got, what, sentence}) {
      EXPECT_FALSE(contains(page, part)) << part;
    }
    EXPECT_TRUE(contains(page, "1 item is in the score and not shown."));
    EXPECT_TRUE(contains(page, ">0 of 3<"));
  }
}

}  // namespace
}  // namespace raycheck::tests
