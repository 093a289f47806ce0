// Every method of fast/ against every law, with fixed seeds; and the promises that a method is
// known to break, which must stay broken in the same place.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "properties/candidates/fast_candidate.h"
#include "properties/cases/case_text.h"
#include "properties/search/campaign.h"
#include "tests/names.h"
#include "tests/properties/cases/drawing.h"

namespace raycheck::properties {
namespace {

constexpr int kCases = 900;

// The sources that methods are told apart by.
constexpr const char* kOrdinaryCameras = "cameras";
constexpr const char* kPlainCameras = "plain-cameras";
constexpr const char* kFarCameras = "far-camera";
constexpr const char* kOrdinaryRays = "rays";
constexpr const char* kFar = "distance";
constexpr const char* kGrazing = "tangency";

/// What a law must compare in kCases cases of direct/cross, at the least: any law, and those of
/// which more is known about two thirds of what they do compare.
constexpr std::uint64_t kLeastOfAny = 60;
const std::map<std::string_view, std::uint64_t> kLeastCompared = {
    {"frame", 2400},          {"pixel-point", 1700},
    {"bounds", 2500},         {"image-plane", 4500},
    {"centre-pixel", 40},     {"pixel-zero-zero", 550},
    {"density", 2600},        {"square-pixels", 530},
    {"unit-direction", 1700}, {"direction", 1700},
    {"ray-origin", 1700},     {"class", 1750},
    {"nearest-root", 510},    {"backward-error", 510},
    {"parameter", 510},       {"hit-point", 1500},
    {"focal-and-pixel", 970}, {"nearest-sphere", 560},
    {"scaling", 13000},       {"axes", 10500},
    {"look-at", 2900},        {"up", 1300},
    {"growing-radius", 1300}, {"refusal", 16000},
    {"visible-sphere", 9500}, {"image", 1400},
    {"plan-left-out", 20000}, {"plan-rectangles", 44000},
    {"plan-roots", 40000}};

CampaignResult campaign(std::string_view law, const Candidate& candidate,
                        std::string_view source = {}, int cases = kCases) {
  CampaignOptions options;
  options.cases = cases;
  options.level = Level::kExtreme;
  if (!source.empty()) options.sources = {chosen_source(source)};
  return run_campaign(*find_law(law), candidate, options);
}

void expect_holds(const Law& law, const Candidate& candidate, std::string_view source = {}) {
  const CampaignResult result = campaign(law.name, candidate, source);
  EXPECT_FALSE(result.failure.has_value()) << candidate.name << " breaks: " << law.sentence << "\n"
                                           << result.failure->replay << "\n"
                                           << scene_text(result.failure->shrunk);
  EXPECT_GE(result.counts.cases, kCases);
}

/// Near tangency most wrong classes are excused: a defect is one case in a thousand there.
constexpr int kCasesUntilCaught = 20000;

void expect_caught(std::string_view law, const Candidate& candidate, std::string_view source) {
  const CampaignResult result = campaign(law, candidate, source, kCasesUntilCaught);
  EXPECT_TRUE(result.failure.has_value()) << candidate.name << " keeps " << law << " on " << source;
}

/// A plan is made of the scene alone, before there are rays and hits: the same for every method.
bool is_of_plans(const Law& law) { return needs_any(law.needs, Needs::kPlan); }

/// The laws to which it makes a difference how spheres are intersected.
std::vector<std::string> laws_of_intersections() {
  std::vector<std::string> names;
  for (const Law& law : laws()) {
    if (is_of_plans(law)) continue;
    if (speaks_of_intersections(law) || !speaks_of_cameras(law)) names.emplace_back(law.name);
  }
  return names;
}

class EachLaw : public testing::TestWithParam<std::string> {};

TEST_P(EachLaw, HoldsForDirectCross) {
  const Law& law = *find_law(GetParam());
  const CampaignResult result = campaign(law.name, drawing_candidate());
  EXPECT_FALSE(result.failure.has_value()) << scene_text(result.failure->shrunk);
  EXPECT_GE(result.counts.cases, kCases);
  const auto least = kLeastCompared.find(law.name);
  EXPECT_GE(result.verdict.compared(), least == kLeastCompared.end() ? kLeastOfAny : least->second);
  // Excuses are for the few: a law that excuses most of what it compares says nothing.
  std::uint64_t excused = result.verdict.count(Standing::kExcused);
  for (const auto& [quantity, tally] : result.verdict.tallies()) excused += tally.ill_conditioned;
  EXPECT_LT(2 * excused, result.verdict.compared());
}

TEST_P(EachLaw, HoldsForFocalCross) {
  expect_holds(*find_law(GetParam()), fast_candidate(fast::kFocalRays, fast::kCross));
}

INSTANTIATE_TEST_SUITE_P(Laws, EachLaw, testing::ValuesIn(names_of(laws())), by_name);

Candidate with_direct_rays(std::string_view intersection) {
  for (const fast::IntersectMethod* method : fast::intersect_methods()) {
    if (method->name == intersection) return fast_candidate(fast::kDirectRays, *method);
  }
  throw std::invalid_argument(std::string(intersection));
}

/// The methods that keep their promises everywhere, or those that do not.
std::vector<std::string> methods(bool keep) {
  std::vector<std::string> names;
  for (const fast::IntersectMethod* method : fast::intersect_methods()) {
    if (method->not_kept.empty() == keep) names.emplace_back(method->name);
  }
  return names;
}

/// `cross` aside, which has its own test.
std::vector<std::string> keepers() {
  std::vector<std::string> names = methods(true);
  std::erase(names, fast::kCross.name);
  return names;
}

class KeptEverywhere : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(KeptEverywhere, Holds) {
  const auto& [method, law] = GetParam();
  expect_holds(*find_law(law), with_direct_rays(method));
}

INSTANTIATE_TEST_SUITE_P(MethodsAndLaws, KeptEverywhere,
                         testing::Combine(testing::ValuesIn(keepers()),
                                          testing::ValuesIn(laws_of_intersections())),
                         [](const testing::TestParamInfo<KeptEverywhere::ParamType>& the_test) {
                           return identifier(std::get<0>(the_test.param) + "_" +
                                             std::get<1>(the_test.param));
                         });

/// fast/robust_test.cpp holds it to that.
TEST(Robust, PromisesTheExactClass) { EXPECT_TRUE(with_direct_rays("robust").exact_class); }

/// Methods that make rays, where they keep all laws but some.
struct RaysKept {
  const char* name;
  const fast::PixelRayMethod* method;
  std::set<std::string> broken;
  const char* source = "";  ///< Empty: everywhere.
};
const RaysKept kRaysKept[] = {
    // P - E cancels, and a hit inherits the error of its ray's direction.
    {"Lecture",
     &fast::kLectureRays,
     {"direction", "parameter", "hit-point", "axes", "focal-and-pixel"}},
    {"Incremental", &fast::kIncrementalRays, {"bounds"}},
    {"SingleNearTheWorldsOrigin", &fast::kSingleRays, {}, kOrdinaryCameras},
};

struct KeptLaw {
  RaysKept kept;
  std::string law;
};

/// Of all laws to which it makes a difference how rays are made.
std::vector<KeptLaw> kept_laws() {
  std::vector<KeptLaw> all;
  for (const RaysKept& kept : kRaysKept) {
    for (const std::string& law : names_of(laws())) {
      if (!is_of_plans(*find_law(law)) && !kept.broken.contains(law)) all.push_back({kept, law});
    }
  }
  return all;
}

class EachLawOfRays : public testing::TestWithParam<KeptLaw> {};

TEST_P(EachLawOfRays, HoldsWhereItIsKept) {
  const auto& [kept, law] = GetParam();
  expect_holds(*find_law(law), fast_candidate(*kept.method, fast::kCross), kept.source);
}

INSTANTIATE_TEST_SUITE_P(Laws, EachLawOfRays, testing::ValuesIn(kept_laws()),
                         [](const testing::TestParamInfo<KeptLaw>& the_test) {
                           return identifier(the_test.param.kept.name + ("_" + the_test.param.law));
                         });

class LessStableMethod : public testing::TestWithParam<std::string> {
 protected:
  Candidate candidate() const { return with_direct_rays(GetParam()); }
};

TEST_P(LessStableMethod, IsCaughtOnFarAndGrazingSpheres) {
  for (const auto& [law, source] : {std::pair("class", kFar),
                                    {"class", kGrazing},
                                    {"parameter", kOrdinaryRays},
                                    {"parameter", kFar}}) {
    expect_caught(law, candidate(), source);
  }
}

TEST_P(LessStableMethod, HoldsOnOrdinaryCameras) {
  for (const std::string& law : laws_of_intersections()) {
    expect_holds(*find_law(law), candidate(), kOrdinaryCameras);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, LessStableMethod, testing::ValuesIn(methods(false)), by_name);

TEST(RaysOfLessStableMethods, AreCaughtFarFromTheOriginAndByTheBitsOfTheLastColumn) {
  for (const auto& [rays, law, source] : {std::tuple(&fast::kLectureRays, "direction", kFarCameras),
                                          {&fast::kSingleRays, "direction", kFarCameras},
                                          {&fast::kIncrementalRays, "bounds", kPlainCameras}}) {
    expect_caught(law, fast_candidate(*rays, fast::kCross), source);
  }
}

TEST(FocalRays, LeaveOutWhatSpeaksOfPixelPoints) {
  const Candidate focal = fast_candidate(fast::kFocalRays, fast::kCross);
  for (const char* law : {"pixel-point", "bounds", "image-plane", "centre-pixel", "pixel-zero-zero",
                          "density", "square-pixels", "focal-and-pixel"}) {
    const CampaignResult result = campaign(law, focal);
    EXPECT_EQ(result.counts.left_out + result.counts.not_judged, result.counts.cases) << law;
    EXPECT_EQ(result.verdict.compared(), 0u) << law;
    EXPECT_FALSE(result.counts.reason.empty()) << law;
  }
}

}  // namespace
}  // namespace raycheck::properties
