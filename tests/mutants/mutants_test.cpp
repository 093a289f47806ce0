#include "tests/mutants/mutants.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "properties/cases/case_text.h"
#include "properties/search/campaign.h"
#include "scene/files/scene_file.h"
#include "scene/validate.h"
#include "tests/names.h"

namespace raycheck::mutants {
namespace {

using namespace properties;

/// As many cases as the first report that a user sees has.
CampaignOptions at(Level level) {
  CampaignOptions options;
  options.level = level;
  return options;
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const Mutant& mutant : all_mutants()) result.push_back(mutant.candidate.name);
  return result;
}

Mutant mutant_named(const std::string& name) {
  for (Mutant& mutant : all_mutants()) {
    if (mutant.candidate.name == name) return mutant;
  }
  throw std::invalid_argument("no mutant is called " + name);
}

bool breaks(const Law& law, const Case& the_case, const Candidate& candidate) {
  Trial trial(the_case, candidate);
  return !apply(law, trial).holds();
}

class EachMutant : public testing::TestWithParam<std::string> {};

TEST_P(EachMutant, IsCaughtByTheLawsItNames) {
  const Mutant mutant = mutant_named(GetParam());
  ASSERT_FALSE(mutant.caught_by.empty());
  for (const std::string_view law_name : mutant.caught_by) {
    SCOPED_TRACE(std::string(law_name) + ": " + std::string(mutant.sentence));
    const Law* law = find_law(law_name);
    ASSERT_NE(law, nullptr);
    const CampaignResult result = run_campaign(*law, mutant.candidate, at(mutant.level));
    ASSERT_TRUE(result.failure.has_value());
    const Failure& failure = *result.failure;
    EXPECT_TRUE(scene::defects(failure.shrunk.scene).empty());
    EXPECT_TRUE(breaks(*law, failure.shrunk, mutant.candidate));
    // By a wrong answer, not by a throw.
    EXPECT_NE(failure.verdict.worst(1).front().wrong, Wrong::kRefused);
    EXPECT_NE(failure.verdict.worst(1).front().wrong, Wrong::kFailed);

    const Replay replay = parse_replay(failure.replay);
    EXPECT_EQ(replay.law, law);
    EXPECT_EQ(replay.candidate, mutant.candidate.name);
    const CampaignResult again = run_replay(replay, mutant.candidate);
    ASSERT_TRUE(again.failure.has_value()) << failure.replay;
    EXPECT_EQ(again.failure->shrunk.scene, failure.shrunk.scene);

    Case read{scene::read_toml(scene_text(failure.shrunk), "shrunk").scene, {}};
    EXPECT_EQ(read.scene, failure.shrunk.scene);
    if (read.scene.camera) {
      const scene::Camera& camera = *read.scene.camera;
      ASSERT_LE(camera.width * camera.height, 1 << 20);
      read.pixels = all_pixels(camera);
    }
    EXPECT_TRUE(breaks(*law, read, mutant.candidate));
  }
}

INSTANTIATE_TEST_SUITE_P(Mutants, EachMutant, testing::ValuesIn(names()), by_name);

/// What a user's first report on origins near a surface says.
TEST(Mutants, OfTheStableFormulaBreakNearTheSurface) {
  const Mutant mutant = mutant_named("cancelling-roots");
  const auto is_broken = [&](const char* law, int severity) {
    CampaignOptions near;
    near.sources = {chosen_source("surface@" + std::to_string(severity))};
    return run_campaign(*find_law(law), mutant.candidate, near).failure.has_value();
  };
  EXPECT_TRUE(is_broken("class", 16));
  for (int severity = 12; severity < 16; ++severity) {
    EXPECT_TRUE(is_broken("parameter", severity)) << severity;
    EXPECT_TRUE(is_broken("backward-error", severity)) << severity;
  }
}

TEST(Mutants, HaveNamesOfTheirOwn) {
  const auto all = names();
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
  EXPECT_GE(all.size(), 25u);
}

TEST(Mutants, BreakEveryLaw) {
  std::set<std::string_view> caught;
  for (const Mutant& mutant : all_mutants()) {
    caught.insert(mutant.caught_by.begin(), mutant.caught_by.end());
  }
  for (const Law& law : laws()) EXPECT_TRUE(caught.contains(law.name)) << law.name;
}

TEST(Mutants, ComeFromACandidateThatBreaksNone) {
  for (const Law& law : laws()) {
    const CampaignResult result = run_campaign(law, unmutated(), at(Level::kDemanding));
    EXPECT_FALSE(result.failure.has_value()) << law.name << "\n"
                                             << scene_text(result.failure->shrunk);
    EXPECT_EQ(result.counts.cases, kCampaignCases) << law.name;
    EXPECT_GT(result.verdict.compared(), 20u) << law.name;
  }
}

}  // namespace
}  // namespace raycheck::mutants
