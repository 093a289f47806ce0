// Every method of fast/ against every law, with fixed seeds; and the promises that a method is
// known to break, which must stay broken in the same place.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "properties/campaign.h"
#include "properties/fast_candidate.h"

namespace raycheck::properties {
namespace {

constexpr int kCases = 900;

/// What a law must compare in kCases cases of direct/cross, at the least: about two thirds of what
/// it does compare.
const std::map<std::string_view, std::uint64_t> kLeastCompared = {
    {"frame", 2400},          {"pixel-point", 1700},   {"bounds", 2500},
    {"image-plane", 4500},    {"centre-pixel", 60},    {"pixel-zero-zero", 550},
    {"density", 2600},        {"square-pixels", 530},  {"unit-direction", 1700},
    {"direction", 1700},      {"ray-origin", 1700},    {"class", 1750},
    {"nearest-root", 510},    {"parameter", 510},      {"hit-point", 1500},
    {"focal-and-pixel", 970}, {"nearest-sphere", 560}, {"scaling", 13000},
    {"axes", 10500},          {"look-at", 2900},       {"up", 1300},
    {"growing-radius", 1300}, {"refusal", 16000}};

CampaignResult campaign(std::string_view law, const Candidate& candidate,
                        std::string_view source = {}, int cases = kCases) {
  CampaignOptions options;
  options.cases = cases;
  if (!source.empty()) options.sources = {chosen_source(source)};
  return run_campaign(*find_law(law), candidate, options);
}

void expect_holds(const Law& law, const Candidate& candidate, std::string_view source = {}) {
  const CampaignResult result = campaign(law.name, candidate, source);
  EXPECT_FALSE(result.failure.has_value()) << candidate.name << " breaks: " << law.sentence << "\n"
                                           << result.failure->replay << "\n"
                                           << text(result.failure->shrunk);
  EXPECT_EQ(result.cases, kCases);
}

/// Near tangency most wrong classes are excused: a defect is one case in a thousand there.
constexpr int kCasesUntilCaught = 20000;

void expect_caught(std::string_view law, const Candidate& candidate, std::string_view source) {
  const CampaignResult result = campaign(law, candidate, source, kCasesUntilCaught);
  EXPECT_TRUE(result.failure.has_value()) << candidate.name << " keeps " << law << " on " << source;
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const Law& law : laws()) names.emplace_back(law.name);
  return names;
}

/// The laws to which it makes a difference how spheres are intersected.
std::vector<std::string> laws_of_intersections() {
  std::vector<std::string> names;
  for (const Law& law : laws()) {
    if (law.subject != Law::Subject::kCamera) names.emplace_back(law.name);
  }
  return names;
}

/// All but the laws that measure directions and hits, or relate hits from two origins: P - E
/// cancels, and a hit inherits the error of its ray's direction.
std::vector<std::string> laws_of_lecture_rays() {
  std::vector<std::string> names = law_names();
  const std::set<std::string> broken = {"direction", "parameter", "hit-point", "focal-and-pixel"};
  std::erase_if(names, [&](const std::string& name) { return broken.contains(name); });
  return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& the_test) {
  std::string name = the_test.param;
  for (char& letter : name) {
    if (letter == '-') letter = '_';
  }
  return name;
}

class EachLaw : public testing::TestWithParam<std::string> {};

TEST_P(EachLaw, HoldsForDirectCross) {
  const Law& law = *find_law(GetParam());
  const Candidate candidate = fast_candidate(fast::kDirectRays, fast::kCross);
  const CampaignResult result = campaign(law.name, candidate);
  EXPECT_FALSE(result.failure.has_value()) << text(result.failure->shrunk);
  EXPECT_EQ(result.cases, kCases);
  ASSERT_TRUE(kLeastCompared.contains(law.name));
  EXPECT_GE(result.verdict.compared(), kLeastCompared.at(law.name));
  // Excuses are for the few: a law that excuses most of what it compares says nothing.
  std::uint64_t excused = result.verdict.excused();
  for (const auto& [quantity, tally] : result.verdict.tallies()) excused += tally.ill_conditioned;
  EXPECT_LT(2 * excused, result.verdict.compared());
}

TEST_P(EachLaw, HoldsForFocalCross) {
  expect_holds(*find_law(GetParam()), fast_candidate(fast::kFocalRays, fast::kCross));
}

INSTANTIATE_TEST_SUITE_P(Laws, EachLaw, testing::ValuesIn(law_names()), test_name);

class EachIntersectionLaw : public testing::TestWithParam<std::string> {};

TEST_P(EachIntersectionLaw, HoldsForDirectPerpendicular) {
  expect_holds(*find_law(GetParam()), fast_candidate(fast::kDirectRays, fast::kPerpendicular));
}

INSTANTIATE_TEST_SUITE_P(Laws, EachIntersectionLaw, testing::ValuesIn(laws_of_intersections()),
                         test_name);

class EachLawOfLectureRays : public testing::TestWithParam<std::string> {};

TEST_P(EachLawOfLectureRays, Holds) {
  expect_holds(*find_law(GetParam()), fast_candidate(fast::kLectureRays, fast::kCross));
}

INSTANTIATE_TEST_SUITE_P(Laws, EachLawOfLectureRays, testing::ValuesIn(laws_of_lecture_rays()),
                         test_name);

class LessStableMethod : public testing::TestWithParam<std::string> {
 protected:
  Candidate candidate() const {
    for (const fast::IntersectMethod* method : fast::intersect_methods()) {
      if (method->name == GetParam()) return fast_candidate(fast::kDirectRays, *method);
    }
    throw std::invalid_argument(GetParam());
  }
};

TEST_P(LessStableMethod, IsCaughtByTheClassOfFarAndGrazingSpheres) {
  expect_caught("class", candidate(), "distance");
  expect_caught("class", candidate(), "tangency");
}

TEST_P(LessStableMethod, IsCaughtByTheParameterOfFarSpheres) {
  expect_caught("parameter", candidate(), "distance");
}

TEST_P(LessStableMethod, HoldsOnOrdinaryCameras) {
  for (const std::string& law : laws_of_intersections()) {
    expect_holds(*find_law(law), candidate(), "cameras");
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, LessStableMethod,
                         testing::Values("quadratic", "lecture", "stable-quadratic"), test_name);

TEST(LectureRays, AreCaughtByTheDirectionFromFarEyes) {
  expect_caught("direction", fast_candidate(fast::kLectureRays, fast::kCross), "far-camera");
}

TEST(LectureRays, HaveTheRightDirectionFromPlainEyes) {
  expect_holds(*find_law("direction"), fast_candidate(fast::kLectureRays, fast::kCross),
               "plain-cameras");
}

TEST(FocalRays, LeaveOutWhatSpeaksOfPixelPoints) {
  const Candidate focal = fast_candidate(fast::kFocalRays, fast::kCross);
  for (const char* law : {"pixel-point", "bounds", "image-plane", "centre-pixel", "pixel-zero-zero",
                          "density", "square-pixels", "focal-and-pixel"}) {
    const CampaignResult result = campaign(law, focal);
    EXPECT_EQ(result.left_out, kCases) << law;
    EXPECT_EQ(result.verdict.compared(), 0u) << law;
    EXPECT_FALSE(result.reason.empty()) << law;
  }
}

}  // namespace
}  // namespace raycheck::properties
