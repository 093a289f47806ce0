#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

TEST(PropertiesCommand, reports_a_broken_law_with_a_case_that_check_and_replay_accept) {
  const Outcome result =
      run("properties --filter class --source distance --level extreme --intersect quadratic "
          "--format json");
  EXPECT_EQ(result.exit_code, 1);
  const json report = json::parse(result.out);
  const json& campaign = report["campaigns"][0];
  EXPECT_FALSE(campaign["holds"].get<bool>());
  const std::string path = temporary_file("shrunk.toml", campaign["scene"]);
  EXPECT_EQ(run("check " + path + " --intersect quadratic").exit_code, 1);
  std::filesystem::remove(path);
  const Outcome again = run("properties --replay " + campaign["replay"].get<std::string>());
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_NE(again.out.find("BROKEN"), std::string::npos);
}

TEST(PropertiesCommand, is_the_same_for_the_same_seed) {
  const std::string arguments = "properties --filter frame --cases 50 --seed 7 --format json";
  EXPECT_EQ(run(arguments).out, run(arguments).out);
}

TEST(PropertiesCommand, exits_with_4_when_nothing_was_checked) {
  EXPECT_EQ(run("properties --filter pixel-point --rays focal --cases 5").exit_code, 4);
}

TEST(PropertiesCommand, exits_with_4_when_too_little_was_judged) {
  const Outcome few = run("properties --filter class --source rays --cases 6 --intersect cross");
  EXPECT_EQ(few.exit_code, 4) << few.out;
  EXPECT_NE(few.out.find("too few judged"), std::string::npos) << few.out;
  EXPECT_NE(few.out.find("fewer than 10 answers are right"), std::string::npos) << few.out;
}

TEST(PropertiesCommand, exits_with_4_when_all_lies_outside_the_domain) {
  const Outcome outside = run("properties --filter parameter --source scale@600 --intersect cross");
  EXPECT_EQ(outside.exit_code, 4) << outside.out;
  EXPECT_NE(outside.out.find("not judged here"), std::string::npos) << outside.out;
}

TEST(PropertiesCommand, breaks_laws_for_excuses_when_it_is_strict) {
  const std::string asked = "properties --filter class --source tangency@16 --intersect cross";
  EXPECT_EQ(run(asked).exit_code, 0);
  EXPECT_EQ(run(asked + " --strict").exit_code, 1);
}

TEST(PropertiesCommand, judges_methods_by_the_level_that_is_theirs) {
  const json report = json::parse(
      run("properties --filter class --cases 50 --intersect cross --intersect quadratic --format "
          "json")
          .out);
  EXPECT_EQ(report["campaigns"][0]["level"], "demanding");
  EXPECT_EQ(report["campaigns"][1]["level"], "ordinary");
}

TEST(PropertiesCommand, shows_how_far_beyond_the_level_a_law_holds) {
  const std::string asked = "properties --filter class --source distance --intersect quadratic ";
  const Outcome shown = run(asked + "--frontier");
  EXPECT_EQ(shown.exit_code, 0) << shown.out;
  EXPECT_NE(shown.out.find("frontier: distance up to @"), std::string::npos) << shown.out;
  EXPECT_NE(shown.out.find("that of direct/cross: all of distance"), std::string::npos);
  const Outcome broken = run(asked + "--level extreme");
  EXPECT_EQ(broken.exit_code, 1);
  EXPECT_NE(broken.out.find("    broken on distance@"), std::string::npos) << broken.out;
  EXPECT_NE(broken.out.find("    holds on distance up to @"), std::string::npos) << broken.out;
}

TEST(PropertiesCommand, names_the_mistake_by_which_a_candidate_breaks_a_law) {
  const std::string folder = temporary_file("mistaken", "") + ".d";
  const auto explained = [&](const std::string& mistake, const std::string& law) {
    const json campaign =
        json::parse(run("properties --filter " + law + " --cases 60 --candidate library:" +
                        built_submission("rays.cpp", mistake, folder) + " --format json")
                        .out)["campaigns"][0];
    EXPECT_EQ(campaign["law"], law);
    EXPECT_EQ(campaign["finding"] == "broken", mistake != "none") << mistake;
    return campaign["explanations"];
  };
  EXPECT_TRUE(explained("none", "pixel-zero-zero").empty());
  for (const auto& [mistake, law, sentence] :
       {std::array{"upside_down", "pixel-zero-zero", "rows are upside down"},
        {"far_root", "nearest-root", "the far root is taken for the near one"},
        {"first_sphere_wins", "nearest-sphere", "the first sphere in the file wins"}}) {
    const json found = explained(mistake, law);
    ASSERT_EQ(found.size(), 1u) << mistake << found.dump(2);
    EXPECT_EQ(found[0]["sentence"], sentence);
    EXPECT_GE(found[0]["wrong"], 3);
    EXPECT_GE(found[0]["explained"].get<double>(), 0.9 * found[0]["wrong"].get<double>());
  }
  std::filesystem::remove_all(folder);
}

TEST(PropertiesCommand, fails_with_2_and_says_why) {
  const auto fails = [](const std::string& arguments, const std::string& why) {
    const Outcome result = run("properties " + arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_NE(result.err.find(why), std::string::npos) << arguments << "\n" << result.err;
  };
  fails("--filter nothing", "filter nothing: no law");
  fails("--cases 0", "--cases");
  fails("--source moon", "source moon: no source");
  fails("--source distance@16", "source distance@16: severities of 'distance' are 0 to 15");
  fails("--level easy", "--level");
  fails("--replay class:direct/cross:distance:1 --level extreme", "--level");
  fails("--replay class:direct/cross:distance", "LAW:");
  fails("--replay klass:direct/cross:distance:1", "klass");
  fails("--replay class:direct/none:distance:1", "direct/none");
}

TEST(List, names_every_method_law_and_convention) {
  const Outcome result = run("list");
  EXPECT_EQ(result.exit_code, 0);
  for (const char* name : {"lecture", "direct", "focal", "quadratic", "stable-quadratic",
                           "perpendicular", "cross", "nearest-sphere", "top-first", "tangency"}) {
    EXPECT_NE(result.out.find(name), std::string::npos) << name;
  }
  const json report = json::parse(run("list --format json").out);
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
