#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

TEST(PropertiesCommand, reports_a_broken_law_with_a_case_that_check_and_replay_accept) {
  const json campaign = printed_json(
      "properties --filter class --source distance --level extreme --intersect quadratic",
      1)["campaigns"][0];
  EXPECT_FALSE(campaign["holds"].get<bool>());
  const std::string path = temporary_file("shrunk.toml", campaign["scene"]);
  EXPECT_EQ(run("check " + path + " --intersect quadratic").exit_code, 1);
  const Outcome again = run("properties --replay " + campaign["replay"].get<std::string>(), 1);
  EXPECT_TRUE(has(again.out, "BROKEN"));
}

TEST(PropertiesCommand, reports_the_same_whatever_the_number_of_threads) {
  const std::string asked =
      "properties --level extreme --intersect quadratic --intersect cross --cases 1000 --format "
      "json --threads ";
  const std::string by_one = run(asked + "1").out;
  ASSERT_TRUE(has(by_one, "broken"));
  EXPECT_EQ(run(asked + "2").out, by_one);
  EXPECT_EQ(run(asked + "7").out, by_one);
}

TEST(PropertiesCommand, exits_with_4_when_nothing_too_little_or_nothing_inside_was_judged) {
  for (const auto& [asked, why] :
       {std::pair("pixel-point --rays focal --cases 5", ""),
        {"class --source rays --cases 6 --intersect cross", "fewer than 10 answers are right"},
        {"parameter --source scale@600 --intersect cross", "not judged here"}}) {
    const Outcome outcome = run("properties --filter " + std::string(asked), 4);
    EXPECT_TRUE(has(outcome.out, why));
  }
}

TEST(PropertiesCommand, breaks_laws_for_excuses_when_it_is_strict) {
  const std::string asked = "properties --filter class --source tangency@16 --intersect cross";
  EXPECT_EQ(run(asked).exit_code, 0);
  EXPECT_EQ(run(asked + " --strict").exit_code, 1);
}

TEST(PropertiesCommand, judges_methods_by_the_level_that_is_theirs) {
  const json report =
      printed_json("properties --filter class --cases 50 --intersect cross --intersect quadratic");
  EXPECT_EQ(report["campaigns"][0]["level"], "demanding");
  EXPECT_EQ(report["campaigns"][1]["level"], "ordinary");
}

TEST(PropertiesCommand, says_up_to_which_severity_a_broken_law_holds) {
  const std::string asked = "properties --filter class --source distance --intersect quadratic ";
  const Outcome broken = run(asked + "--level extreme", 1);
  EXPECT_TRUE(has(broken.out, "    broken on distance@"));
  EXPECT_TRUE(has(broken.out, "    holds on distance up to @"));
}

TEST(List, names_every_method_law_and_convention) {
  const json report = printed_json("list");
  EXPECT_EQ(report["laws"].size(), properties::laws().size());
  ASSERT_EQ(report["sources"].size(), properties::case_sources().size());
  for (const json& source : report["sources"]) {
    if (source["name"] == "cameras") {
      EXPECT_TRUE(source["dial"].is_null());
      EXPECT_EQ(source["level"], "ordinary");
    }
    if (source["name"] == "distance") {
      EXPECT_EQ(source["dial"]["highest"], 15);
      EXPECT_LT(source["dial"]["highest_ordinary"], source["dial"]["highest_demanding"]);
    }
  }
}

}  // namespace
}  // namespace raycheck::tests
