#include "properties/search/campaign.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "properties/candidates/fast_candidate.h"
#include "properties/cases/case_text.h"
#include "scene/files/scene_file.h"

namespace raycheck::properties {
namespace {

const Candidate kGood = fast_candidate(fast::kDirectRays, fast::kCross);
const Candidate kBad = fast_candidate(fast::kDirectRays, fast::kQuadratic);

CampaignOptions options(int cases, std::uint64_t seed = 1) {
  CampaignOptions result;
  result.cases = cases;
  result.seed = seed;
  return result;
}

TEST(Campaign, IsTheSameForTheSameOptions) {
  const Law& law = *find_law("class");
  const CampaignResult first = run_campaign(law, kBad, options(500));
  const CampaignResult second = run_campaign(law, kBad, options(500));
  ASSERT_TRUE(first.failure && second.failure);
  EXPECT_EQ(first.failure->replay, second.failure->replay);
  EXPECT_EQ(first.failure->shrunk.scene, second.failure->shrunk.scene);
  EXPECT_EQ(first.cases, second.cases);
  const CampaignResult other = run_campaign(law, kBad, options(500, 2));
  ASSERT_TRUE(other.failure);
  EXPECT_NE(other.failure->replay, first.failure->replay);
}

TEST(Campaign, DoesNotListenToTheEnvironment) {
  const CampaignResult before = run_campaign(*find_law("class"), kBad, options(500));
  ASSERT_EQ(setenv("RC_PARAMS", "seed=12345 max_success=1", 1), 0);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const CampaignResult after = run_campaign(*find_law("class"), kBad, options(500));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  unsetenv("RC_PARAMS");
  ASSERT_TRUE(before.failure && after.failure);
  EXPECT_EQ(after.failure->replay, before.failure->replay);
}

TEST(Campaign, JudgesEveryCaseOfALawThatHolds) {
  const CampaignResult result = run_campaign(*find_law("density"), kGood, options(200));
  EXPECT_FALSE(result.failure);
  EXPECT_EQ(result.cases, 200);
  EXPECT_GT(result.left_out, 0);
  EXPECT_LT(result.left_out, 200);
  EXPECT_EQ(result.reason, "samples at cell centres move with the density");
  EXPECT_GT(result.verdict.compared(), 200u);
}

/// The first ray of each case of a campaign.
std::vector<scene::Ray> first_rays(const std::vector<std::string>& sources) {
  std::vector<scene::Ray> rays;
  Candidate recorder;
  recorder.intersect = [&rays](Candidate::Rays some, Candidate::Spheres spheres,
                               const scene::Conventions&) {
    rays.push_back(some.front());
    return std::vector<SphereHits>(spheres.size());
  };
  CampaignOptions chosen = options(300);
  for (const std::string& name : sources) chosen.sources.push_back(chosen_source(name));
  Law law = *find_law("class");
  law.judge = [](Trial& trial, Verdict&) { trial.hits(0); };
  EXPECT_FALSE(run_campaign(law, recorder, chosen).failure);
  return rays;
}

TEST(Campaign, DrawsTheOtherCasesAsBeforeWhenASourceIsAdded) {
  const std::vector<scene::Ray> before = first_rays({"rays", "far-world", "inside"});
  const std::vector<scene::Ray> after = first_rays({"horizon", "rays", "far-world", "inside"});
  ASSERT_EQ(before.size(), 300u);
  ASSERT_EQ(after.size(), before.size());
  int same = 0;
  for (std::size_t k = 0; k < before.size(); ++k) same += before[k] == after[k] ? 1 : 0;
  // Three in four, not the one in four that chance would make of the same seeds.
  EXPECT_NEAR(same, 225, 30);
}

TEST(Campaign, SaysWhenNoSourceSuitsTheLaw) {
  CampaignOptions rays_only = options(100);
  rays_only.sources = {chosen_source("rays")};
  const CampaignResult result = run_campaign(*find_law("frame"), kGood, rays_only);
  EXPECT_EQ(result.cases, 0);
  EXPECT_FALSE(result.reason.empty());
}

TEST(Campaign, EndsWhenItIsInterrupted) {
  int asked = 0;
  RunControl until_ten;
  until_ten.interrupted = [&] { return ++asked > 10; };
  const CampaignResult result = run_campaign(*find_law("class"), kGood, options(1000), until_ten);
  EXPECT_EQ(result.cases, 10);
  EXPECT_EQ(asked, 11);
}

TEST(Campaign, StopsAtTheFirstFailureAndShrinksIt) {
  CampaignOptions far = options(500);
  far.sources = {chosen_source("distance")};
  const CampaignResult result = run_campaign(*find_law("class"), kBad, far);
  ASSERT_TRUE(result.failure);
  EXPECT_LT(result.cases, 500);
  const Case& shrunk = result.failure->shrunk;
  EXPECT_EQ(shrunk.scene.spheres.size(), 1u);
  EXPECT_EQ(shrunk.scene.rays.size(), 1u);
  EXPECT_FALSE(result.failure->verdict.holds());
  // What was found is counted once; the tries of shrinking are not.
  EXPECT_LE(result.verdict.compared(), 3u * static_cast<unsigned>(result.cases));
}

TEST(Campaign, HoldsErrorsAgainstTheBoundAskedFor) {
  CampaignOptions strict = options(100);
  strict.max_error = 0.01;
  EXPECT_TRUE(run_campaign(*find_law("parameter"), kGood, strict).failure);
}

TEST(Replay, FindsTheFailureAgain) {
  const CampaignResult first = run_campaign(*find_law("nearest-sphere"), kBad, options(900));
  ASSERT_TRUE(first.failure);
  const Replay replay = parse_replay(first.failure->replay);
  EXPECT_EQ(replay.law->name, "nearest-sphere");
  EXPECT_EQ(replay.candidate, kBad.name);
  const CampaignResult again = run_replay(replay, kBad);
  ASSERT_TRUE(again.failure);
  EXPECT_EQ(again.cases, 1);
  EXPECT_EQ(again.failure->shrunk.scene, first.failure->shrunk.scene);
  EXPECT_EQ(again.failure->replay, first.failure->replay);
  EXPECT_FALSE(run_replay(replay, kGood).failure);
}

std::string error_of_replay(std::string_view replay) {
  try {
    parse_replay(replay);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(Replay, NamesThePartThatIsWrong) {
  EXPECT_EQ(parse_replay("class:a/b:distance:00ff").seed, 255u);
  EXPECT_EQ(parse_replay("class:a/b:distance@3:1").source.severity, 3);
  EXPECT_NE(error_of_replay("").find("LAW:CANDIDATE:SOURCE:SEED"), std::string::npos);
  EXPECT_NE(error_of_replay("class:a/b:distance").find("'class:a/b:distance'"), std::string::npos);
  EXPECT_EQ(parse_replay("class:source:a.cpp:distance:1").candidate, "source:a.cpp");
  EXPECT_NE(error_of_replay("clas:a/b:distance:1").find("law is called 'clas'"), std::string::npos);
  EXPECT_NE(error_of_replay("class:a/b:distance@16:1").find("are 0 to 15"), std::string::npos);
  EXPECT_NE(error_of_replay("class:a/b:dist:1").find("source of cases is called 'dist'"),
            std::string::npos);
  for (const char* seed : {"", "x1", "1x", "-1", "0x1", "10000000000000000"}) {
    EXPECT_NE(error_of_replay("class:a/b:distance:" + std::string(seed)).find("hexadecimal seed"),
              std::string::npos)
        << seed;
  }
}

TEST(CaseText, IsASceneThatReadsBack) {
  for (const CaseSource& source : case_sources()) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const Case the_case = any_case(source, seed);
      const std::string lines = scene_text(the_case, "why");
      EXPECT_EQ(scene::read_toml(lines, "case").scene, the_case.scene) << source.name;
      EXPECT_EQ(lines.rfind("# why\n", 0), 0u);
      EXPECT_EQ(lines.find("# pixels: (") != std::string::npos, source.has_camera);
    }
  }
}

}  // namespace
}  // namespace raycheck::properties
