// Sound code passes the level that it should, whatever the seed.

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "properties/candidates/fast_candidate.h"
#include "properties/cases/case_text.h"
#include "tests/campaigns.h"
#include "tests/names.h"

namespace raycheck::mutants {
namespace {

using namespace properties;

/// Cases of each law and seed: one or two of each severity of each source.
constexpr int kCasesOfSeed = 100;

/// Of so many comparisons one may be undecided: a choice among far spheres nearly tied.
constexpr std::uint64_t kComparedPerUndecided = 10000;

/// How many seeds are tried; by hand RAYCHECK_LEVEL_SEEDS=1000.
int seeds() {
  const char* const given = std::getenv("RAYCHECK_LEVEL_SEEDS");
  return given != nullptr ? std::atoi(given) : 10;
}

struct Sound {
  std::string name;
  Level level;
  std::vector<std::string_view> laws;  ///< Empty: all.
};
void PrintTo(const Sound& sound, std::ostream* out) { *out << sound.name; }

/// What the textbook's forms can do; s loses digits with the distance already on ordinary cases.
const std::vector<std::string_view> kDecisions = {"class", "nearest-root", "nearest-sphere",
                                                  "growing-radius"};

std::vector<Sound> sound_code() {
  std::vector<Sound> all;
  for (const fast::IntersectMethod* method : fast::intersect_methods()) {
    if (method->unit_roundoff != kDoubleRoundoff) continue;
    const bool is_textbook = !method->not_kept.empty();
    all.push_back({std::string(method->name), is_textbook ? Level::kOrdinary : Level::kDemanding,
                   is_textbook ? kDecisions : std::vector<std::string_view>{}});
  }
  return all;
}

Candidate candidate_named(const std::string& name) {
  for (const fast::IntersectMethod* method : fast::intersect_methods()) {
    if (method->name == name) return fast_candidate(fast::kDirectRays, *method);
  }
  throw std::invalid_argument(name);
}

class SoundCode : public testing::TestWithParam<Sound> {};

TEST_P(SoundCode, PassesItsLevelWithEverySeed) {
  ASSERT_GT(seeds(), 0);
  const Candidate candidate = candidate_named(GetParam().name);
  std::vector<std::string_view> names = GetParam().laws;
  if (names.empty()) {
    for (const Law& law : laws()) {
      // One of them with all laws: the others make the same rays.
      if (speaks_of_intersections(law) || GetParam().name == "cross") names.push_back(law.name);
    }
  }
  std::vector<Verdict> verdicts(names.size());
  for (int seed = 1; seed <= seeds(); ++seed) {
    CampaignOptions options;
    options.cases = kCasesOfSeed;
    options.level = GetParam().level;
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

INSTANTIATE_TEST_SUITE_P(Levels, SoundCode, testing::ValuesIn(sound_code()),
                         [](const auto& the_test) { return identifier(the_test.param.name); });

}  // namespace
}  // namespace raycheck::mutants
