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
    EXPECT_FALSE(run_replay(replay, unmutated()).failure);

    const std::string lines = scene_text(failure.shrunk, "why");
    EXPECT_EQ(lines.rfind("# why\n", 0), 0u);
    Case read{scene::read_toml(lines, "shrunk").scene, {}};
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
    EXPECT_GE(result.counts.cases, kCampaignCases) << law.name;
    EXPECT_GT(result.verdict.compared(), 20u) << law.name;
  }
}

/// What is small enough to be overlooked, on ordinary cases but where it is said.
struct SmallFault {
  const char* name;
  Fault fault;
  std::vector<const char*> laws;
  Level level = Level::kOrdinary;
};

TEST(SmallFaults, BreakTheirLaws) {
  const SmallFault faults[] = {
      {"s-2^-20", {.s = 0x1p-20}, {"parameter", "backward-error"}},
      {"s-2^-46", {.s = 0x1p-46}, {"parameter"}},
      {"Q-2^-46", {.Q = 0x1p-46}, {"hit-point"}},
      {"D-2^-20", {.D = 0x1p-20}, {"direction"}},
      {"D-2^-46", {.D = 0x1p-46}, {"direction"}},
      {"epsilon-1e-3", {.epsilon = 1e-3}, {"class", "scaling"}},
      {"epsilon-1e-12", {.epsilon = 1e-12}, {"scaling"}},
      {"band-2^-20", {.band = 0x1p-20}, {"class"}, Level::kDemanding},
  };
  for (const auto& [name, fault, laws, level] : faults) {
    for (const char* law : laws) {
      const Candidate candidate = careful_candidate(name, fault);
      EXPECT_TRUE(run_campaign(*find_law(law), candidate, at(level)).failure)
          << name << ", " << law;
    }
  }
}

}  // namespace
}  // namespace raycheck::mutants
