// The laws that a mutant names catch it; sound code passes its level with every seed.

#include "tests/mutants/mutants.h"

#include "properties/candidates/fast_candidate.h"
#include "properties/cases/case_text.h"
#include "properties/search/campaign.h"
#include "scene/files/scene_file.h"
#include "scene/validate.h"
#include "tests/campaigns.h"
#include "tests/names.h"
#include "tests/testing.h"

namespace raycheck::mutants {
namespace {

using namespace properties;

/// The options of a user's first run, with the default number of cases.
CampaignOptions at(Level level) { return options_of(CampaignOptions().cases, {}, level); }

const std::vector<Mutant>& all() {
  static const std::vector<Mutant> kAll = all_mutants();
  return kAll;
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const Mutant& mutant : all()) result.push_back(mutant.candidate.name);
  return result;
}

bool breaks(const Law& law, const Case& the_case, const Candidate& candidate) {
  Trial trial(the_case, candidate);
  return !apply(law, trial).holds();
}

class EachMutant : public testing::TestWithParam<std::size_t> {};

TEST_P(EachMutant, IsCaughtByTheLawsItNames) {
  const Mutant& mutant = all()[GetParam()];
  ASSERT_FALSE(mutant.caught_by.empty());
  const std::vector<const Law*> its_laws = laws_named(mutant.caught_by);
  const auto results = run_campaigns(its_laws, mutant.candidate, at(mutant.level));
  for (std::size_t k = 0; k < results.size(); ++k) {
    const Law* const law = its_laws[k];
    const CampaignResult& result = results[k];
    SCOPED_TRACE(std::string(law->name) + ": " + std::string(mutant.sentence));
    ASSERT_TRUE(result.failure.has_value());
    const Failure& failure = *result.failure;
    EXPECT_TRUE(scene::defects(failure.shrunk.scene).empty());
    EXPECT_TRUE(breaks(*law, failure.shrunk, mutant.candidate));
    // The mutant is caught by a wrong answer, not by an exception.
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

INSTANTIATE_TEST_SUITE_P(Mutants, EachMutant, testing::Range(std::size_t{0}, all().size()),
                         [](const auto& the_test) { return identifier(names()[the_test.param]); });

TEST(Mutants, HaveDistinctNames) {
  const auto its = names();
  EXPECT_EQ(std::set<std::string>(its.begin(), its.end()).size(), its.size());
  EXPECT_GE(its.size(), 25u);
}

TEST(Mutants, BreakEveryLaw) {
  std::set<std::string_view> caught;
  for (const Mutant& mutant : all()) {
    caught.insert(mutant.caught_by.begin(), mutant.caught_by.end());
  }
  for (const Law& law : laws()) EXPECT_TRUE(caught.contains(law.name)) << law.name;
}

TEST(Mutants, ComeFromACandidateThatBreaksNoLaw) {
  std::vector<const Law*> every;
  for (const Law& law : laws()) every.push_back(&law);
  const auto results = run_campaigns(every, unmutated(), at(Level::kDemanding));
  for (std::size_t k = 0; k < results.size(); ++k) {
    SCOPED_TRACE(every[k]->name);
    const CampaignResult& result = results[k];
    EXPECT_FALSE(result.failure.has_value()) << scene_text(result.failure->shrunk);
    EXPECT_GE(result.counts.cases, kCampaignCases);
    EXPECT_GT(result.verdict.compared(), 20u);
  }
}

TEST(Mutants, PickAsACandidateThatBreaksNoLaw) {
  std::vector<const Law*> every;
  for (const Law& law : laws()) every.push_back(&law);
  std::size_t judged = 0;
  for (const CampaignResult& result :
       run_campaigns(every, picking_candidate(), at(Level::kDemanding))) {
    EXPECT_FALSE(result.failure) << result.failure->replay << scene_text(result.failure->shrunk);
    judged += result.verdict.compared() > 100 ? 1 : 0;
  }
  EXPECT_EQ(judged, 6u);  // class, nearest-root, parameter, hit-point, scaling, axes
}

/// An error that is small enough to be overlooked, on ordinary cases by default.
struct SmallFault {
  const char* name;
  Fault fault;
  std::vector<std::string_view> laws;
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
    const auto results = run_campaigns(laws_named(laws), careful_candidate(name, fault), at(level));
    for (std::size_t k = 0; k < results.size(); ++k) {
      EXPECT_TRUE(results[k].failure) << name << ", " << laws[k];
    }
  }
}

/// The loss of digits that is allowed for the textbook's formula on ordinary cases hides no larger
/// error, not even in floats.
TEST(SmallFaults, BreakTheirLawsWhereOnlyOrdinaryCasesArePromised) {
  const std::tuple<const char*, Fault, std::vector<std::string_view>, scene::Precision> faults[] = {
      {"s-2^-36", {.s = 0x1p-36}, {"parameter", "backward-error"}, scene::Precision::kDouble},
      {"D-2^-36", {.D = 0x1p-36}, {"direction"}, scene::Precision::kDouble},
      {"s-2^-10", {.s = 0x1p-10}, {"parameter", "backward-error"}, scene::Precision::kSingle},
      {"Q-2^-10", {.Q = 0x1p-10}, {"hit-point"}, scene::Precision::kSingle},
      {"band-2^-4", {.band = 0x1p-4}, {"class"}, scene::Precision::kSingle}};
  for (const auto& [name, fault, laws, precision] : faults) {
    Candidate candidate = judged_in(precision, careful_candidate(name, fault));
    candidate.level = Level::kOrdinary;
    for (const CampaignResult& result :
         run_campaigns(laws_named(laws), candidate, at(Level::kOrdinary))) {
      EXPECT_TRUE(result.failure) << name;
    }
  }
}

/// The number of cases for each law and seed: one or two for each severity of each source.
constexpr int kCasesOfSeed = 100;

/// One in this many comparisons may be undecided: choices among far spheres that nearly tie.
constexpr std::uint64_t kComparedPerUndecided = 10000;

/// The number of seeds to try; for a longer run, set RAYCHECK_LEVEL_SEEDS=1000.
int seeds() {
  const char* const given = std::getenv("RAYCHECK_LEVEL_SEEDS");
  return given != nullptr ? std::atoi(given) : 10;
}

struct Sound {
  const fast::PixelRayMethod* rays;
  const fast::IntersectMethod* intersect;
};
std::string name_of(const Sound& sound) {
  return std::string(sound.rays->name) + "_" + std::string(sound.intersect->name);
}
void PrintTo(const Sound& sound, std::ostream* out) { *out << name_of(sound); }

const fast::IntersectMethod& intersect_method(std::string_view name) {
  for (const fast::IntersectMethod* method : fast::intersect_methods()) {
    if (method->name == name) return *method;
  }
  throw std::logic_error("no such method");
}
const fast::IntersectMethod& cross_method() { return intersect_method("cross"); }

/// An argument of `properties --replay`, and the methods on which it is tried.
struct IntersectReplay {
  const fast::PixelRayMethod& rays;
  std::string_view intersect;
  const char* replay;
};

/// Every intersection method with the rays of one method, and textbook rays with `cross`.
std::vector<Sound> sound_code() {
  std::vector<Sound> all = {{&fast::kLectureRays, &cross_method()},
                            {&fast::kFocalRays, &cross_method()}};
  for (const fast::IntersectMethod* method : fast::intersect_methods()) {
    if (method->unit_roundoff == kDoubleRoundoff) all.push_back({&fast::kDirectRays, method});
  }
  return all;
}

/// Textbook code promises no bounds, so it is judged by those of direct/cross.
Candidate candidate_of(const Sound& sound) {
  Candidate candidate = fast_candidate(*sound.rays, *sound.intersect);
  if (candidate.level != Level::kOrdinary) return candidate;
  const Candidate usual = fast_candidate(fast::kDirectRays, cross_method());
  candidate.max_error = usual.max_error;
  candidate.max_error_end_to_end = usual.max_error_end_to_end;
  return candidate;
}

class SoundCode : public testing::TestWithParam<Sound> {};

TEST_P(SoundCode, PassesItsLevelWithEverySeed) {
  ASSERT_GT(seeds(), 0);
  const Candidate candidate = candidate_of(GetParam());
  std::vector<std::string_view> names;
  for (const Law& law : laws()) {
    // Only the pair with `cross` is judged by the laws of rays, because the other pairs make the
    // same rays.
    const bool makes_rays = GetParam().intersect == &cross_method();
    if (is_about_intersections(law) || makes_rays) names.push_back(law.name);
  }
  std::vector<Verdict> verdicts(names.size());
  for (int seed = 1; seed <= seeds(); ++seed) {
    CampaignOptions options = options_of(kCasesOfSeed, {}, candidate.level);
    options.seed = static_cast<std::uint64_t>(seed);
    auto results = run_campaigns(laws_named(names), candidate, options);
    for (std::size_t law = 0; law < names.size(); ++law) {
      EXPECT_FALSE(results[law].failure.has_value())
          << names[law] << ", seed " << seed << ": " << results[law].failure->replay << "\n"
          << scene_text(results[law].failure->shrunk);
      verdicts[law].merge(std::move(results[law].verdict));
    }
  }
  for (std::size_t law = 0; law < names.size(); ++law) {
    SCOPED_TRACE(names[law]);
    const Verdict& all = verdicts[law];
    EXPECT_LE(kComparedPerUndecided * all.count(Standing::kUndecided), all.compared());
    if (all.compared() > 0) {
      EXPECT_FALSE(all.too_few_right(kFewestRight));
    }
  }
}

/// In some millions of ordinary cases, two need the condition numbers of the textbook's steps in
/// these laws.
TEST(RareCases, DoNotConvictTextbooks) {
  const IntersectReplay cases[] = {
      {fast::kDirectRays, "quadratic", "focal-and-pixel:direct/quadratic:crowds:106c0a545afa43d3"},
      {fast::kLectureRays, "cross", "axes:lecture/cross:cameras:2f55bf41833f5f58"}};
  for (const auto& [rays, intersect, replay] : cases) {
    const Candidate candidate = candidate_of({&rays, &intersect_method(intersect)});
    const CampaignResult result = run_replay(parse_replay(replay), candidate);
    EXPECT_GT(result.verdict.compared(), 0u) << replay;
    EXPECT_FALSE(result.failure) << replay;
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, SoundCode, testing::ValuesIn(sound_code()),
                         [](const auto& the_test) { return identifier(name_of(the_test.param)); });

}  // namespace
}  // namespace raycheck::mutants
