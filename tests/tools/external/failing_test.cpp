// Candidates that fail on some questions: those are found, and the others judged.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "properties/trial.h"
#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

const std::string kTenSpheres = "scene/examples/ten-spheres.toml";

std::string fails_by(const std::string& how) {
  return "command:python3 tests/candidates/fails.py " + how;
}

/// The discrepancies that blame so.
std::vector<json> blaming(const json& report, const std::string& blame) {
  std::vector<json> found;
  for (const json& one : report["worst"]) {
    if (!one["failed"].is_null() && one["failed"]["blame"] == blame) found.push_back(one);
  }
  return found;
}

int cases(const json& report, const std::string& quantity) {
  const json found = quantity_of(report["quantities"], quantity);
  return found.is_null() ? 0 : found["cases"].get<int>();
}

TEST(FailingCandidate, is_told_the_one_question_whichever_way_it_fails) {
  const json right = judged(kTenSpheres, fails_by("none none"));
  ASSERT_EQ(right["discrepancies"], 0);
  for (const std::string how : {"exit", "abort", "error", "garbage", "hang"}) {
    const json report =
        judged(kTenSpheres, fails_by(how + " one"), how == "hang" ? "--timeout 0.5" : "");
    ASSERT_EQ(report["discrepancies"], 1) << how << report["worst"].dump(2);
    const json& one = report["worst"][0];
    EXPECT_EQ(one["failed"]["blame"], "question") << how;
    EXPECT_EQ(one["pixel"], (json{11, 7})) << how;
    EXPECT_EQ(one["sphere"], 2) << how;
    // The others are judged: every pair but that one, which meets.
    EXPECT_EQ(cases(report, "class"), cases(right, "class") - 1) << how;
    EXPECT_EQ(cases(report, "parameter"), cases(right, "parameter") - 1) << how;
    EXPECT_EQ(cases(report, "direction"), cases(right, "direction")) << how;
    EXPECT_EQ(report["failures"]["found"], 1) << how;
    EXPECT_EQ(report["failures"]["batches"], 1) << how;
  }
}

TEST(FailingCandidate, fails_on_the_scene_that_it_is_told) {
  const json report = judged(kTenSpheres, fails_by("exit one"));
  const std::string scene =
      temporary_file("question.toml", report["worst"][0]["failed"]["scene"].get<std::string>());
  const json again = judged(scene, fails_by("exit one"));
  EXPECT_EQ(again["discrepancies"], 1);
  EXPECT_EQ(cases(again, "class"), 0);
  EXPECT_EQ(judged(scene, fails_by("none none"))["discrepancies"], 0);
}

TEST(FailingCandidate, is_told_the_pixel_whose_ray_it_fails_to_make) {
  const json report = judged(kTenSpheres, fails_by("exit made"));
  ASSERT_EQ(report["discrepancies"], 1) << report["worst"].dump(2);
  EXPECT_EQ(report["worst"][0]["pixel"], (json{5, 7}));
  EXPECT_EQ(report["worst"][0]["sphere"], nullptr);
  EXPECT_EQ(cases(report, "direction"), 255);
  EXPECT_EQ(cases(report, "class"), 2550);
}

TEST(FailingCandidate, is_not_sought_without_end) {
  const json report = judged(kTenSpheres, fails_by("exit lower"), "--top 100");
  EXPECT_EQ(report["failures"]["found"], properties::kMostFailuresSought);
  const std::vector<json> among = blaming(report, "among");
  EXPECT_EQ(among.size(), report["failures"]["not_sought"]);
  EXPECT_EQ(report["discrepancies"], properties::kMostFailuresSought + among.size());
  // Every question about a ray that points down is blamed, once; all others are judged.
  int blamed = properties::kMostFailuresSought;
  for (const json& one : among) blamed += one["failed"]["questions"].get<int>();
  EXPECT_EQ(blamed, 1280);
  EXPECT_EQ(cases(report, "class"), 1280);
}

TEST(FailingCandidate, that_fails_for_no_question_is_told_so) {
  const json report = judged(kTenSpheres, fails_by("once one"), "--top 100");
  EXPECT_EQ(report["failures"]["found"], 0);
  EXPECT_GE(report["failures"]["together"], properties::kMostFailuresSought);
  EXPECT_EQ(blaming(report, "together").size(), report["failures"]["together"]);
  EXPECT_GT(cases(report, "class"), 1000);
}

TEST(FailingCandidate, that_is_silent_is_not_waited_for_without_end) {
  const json report = judged(kTenSpheres, fails_by("hang all"), "--timeout 0.5 --top 100");
  EXPECT_EQ(cases(report, "class"), 0);
  EXPECT_EQ(blaming(report, "question").size(), 1u);
  EXPECT_EQ(blaming(report, "anything").size(), 1u);
}

TEST(FailingCandidate, is_reported_alike_by_any_number_of_threads) {
  const std::string many = "check " + kTenSpheres + " --top 50 --format json --candidate '" +
                           fails_by("error one") + "' --threads ";
  EXPECT_EQ(run(many + "1").out, run(many + "4").out);
}

TEST(FailingCandidate, is_told_one_question_by_properties_and_a_replay) {
  for (const std::string how : {"exit lower", "hang lower"}) {
    const json campaign =
        report_of("properties --filter class --source cameras --cases 20 --timeout 0.5",
                  fails_by(how), 1)["campaigns"][0];
    EXPECT_EQ(campaign["finding"], "broken") << how;
    EXPECT_NE(campaign["replay"], "") << how;
    const std::string scene = campaign["scene"];
    for (const char* what : {"[[sphere]]", "[[ray]]"}) {
      EXPECT_NE(scene.find(what), std::string::npos) << how << "\n" << scene;
      EXPECT_EQ(scene.find(what), scene.rfind(what)) << how << "\n" << scene;
    }
  }
}

}  // namespace
}  // namespace raycheck::tests
