// The quality of answers: a case for every outcome, and the stability of a method on a source.

#include "properties/candidates/fast_candidate.h"
#include "properties/search/stress.h"
#include "properties/search/worst_case.h"
#include "tests/properties/one_ray.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

Candidate that_answers_parameter(double parameter) {
  return that_answers(HitAnswer{parameter, {}});
}

Verdict weigh(std::string_view law, const Case& the_case, const Candidate& candidate) {
  return judge(law, the_case, candidate, {.conditioning = true});
}

/// The outcome of s of a ray at this height. Exactly one answer is weighed.
Outcome outcome(double height, const Candidate& candidate) {
  const Verdict verdict = weigh("parameter", at_height(height), candidate);
  const Tally& tally = verdict.tallies().at(Quantity::kParameter);
  EXPECT_EQ(tally.cases, 1u);
  for (std::size_t k = 0; k < kOutcomeCount; ++k) {
    if (tally.outcomes[k] == 1) return static_cast<Outcome>(k);
  }
  ADD_FAILURE() << "no outcome";
  return Outcome::kExact;
}

/// s of the ray at height 1/2, and the gap between doubles there.
const double kParameter = 5 - std::sqrt(0.75);
constexpr double kGap = 0x1p-50;

TEST(Stability, DistinguishesExactAccurateAndUnstable) {
  EXPECT_EQ(outcome(0.5, that_answers_parameter(kParameter)), Outcome::kExact);
  EXPECT_EQ(outcome(0.5, that_answers_parameter(kParameter + 3 * kGap)), Outcome::kAccurate);
  EXPECT_EQ(outcome(0.5, that_answers_parameter(kParameter + 1000 * kGap)), Outcome::kUnstable);
  EXPECT_EQ(outcome(0.5, that_answers_parameter(kInfinity)), Outcome::kUnstable);
}

TEST(Stability, BlamesTheProblemWhereItsConditionNumberIsLarge) {
  // At height 1 - 2^-40, d^2 is about 2^-39 and kappa about 2^37, so an error of 1e5 ulp is small.
  const double height = 1 - 0x1p-40;
  const double parameter = 5 - std::sqrt((1 - height) * (1 + height));
  const Candidate off = that_answers_parameter(parameter + 1e5 * kGap);
  EXPECT_EQ(outcome(height, off), Outcome::kIllConditioned);
  const Verdict verdict = weigh("parameter", at_height(height), off);
  EXPECT_GT(verdict.tallies().at(Quantity::kParameter).worst_condition.value(), 0x1p16);
  EXPECT_LT(verdict.tallies().at(Quantity::kParameter).worst_ratio, kStableRatio);
}

TEST(Stability, UsesTheBackwardErrorAtATangent) {
  // An error e of s moves Q off the sphere by only e^2: a backward error of about 2^-60, which is
  // harmless.
  EXPECT_EQ(outcome(1, that_answers_parameter(5 - 0x1p-30)), Outcome::kIllConditioned);
  EXPECT_EQ(outcome(1, that_answers_parameter(5 - 0x1p-10)), Outcome::kUnstable);
  const Verdict verdict = weigh("parameter", at_height(1), that_answers_parameter(5 - 0x1p-30));
  EXPECT_TRUE(std::isinf(verdict.tallies().at(Quantity::kParameter).worst_condition.value()));
}

TEST(Stability, DistinguishesDefectsExcusedDecisionsAndThoseOutsideTheDomain) {
  const auto count = [](const Verdict& verdict, Outcome outcome) {
    return verdict.tallies().at(Quantity::kClass).count(outcome);
  };
  const Candidate misses = that_answers({});
  EXPECT_EQ(count(weigh("class", at_height(0.5), misses), Outcome::kWrongDecision), 1u);
  EXPECT_EQ(count(weigh("class", at_height(1), misses), Outcome::kExcusedDecision), 1u);
  EXPECT_EQ(count(weigh("class", at_height(2), misses), Outcome::kExact), 1u);
  Candidate narrow = misses;
  narrow.largest_length = 2;
  EXPECT_EQ(count(weigh("class", at_height(0.5), narrow), Outcome::kOutsideDomain), 1u);
}

TEST(Stress, JudgesIntersectionsOnTheGivenRaysOfACamera) {
  StressOptions options;
  options.cases = 200;
  const std::vector<Candidate> candidates = {fast_candidate(fast::kDirectRays, fast::kCross)};
  const auto results =
      stress({find_case_source("far-camera"), 0}, Stage::kIntersection, candidates, options);
  EXPECT_GE(results[0].inside.tallies().at(Quantity::kClass).cases, 100u);
  EXPECT_EQ(results[0].inside.tallies().count(Quantity::kDirection), 0u);
}

TEST(ErrorSlope, FitsALineThroughLogarithms) {
  const std::vector<int> from_0 = {0, 1, 2, 3, 4, 5, 6};
  const std::vector<double> errors = {1, 100, 1e4, 1e6};
  EXPECT_NEAR(error_slope(10, from_0, errors).value(), 2, 1e-12);
  EXPECT_NEAR(error_slope(2, from_0, errors).value(), 2 / std::log10(2.0), 1e-12);
  EXPECT_FALSE(error_slope(10, from_0, std::vector<double>{1, 0, kInfinity, 2}).has_value());
  const std::vector<double> until_nothing_is_right = {1, 10, 100, 1000, 2000, 1500, 1800};
  EXPECT_NEAR(error_slope(10, from_0, until_nothing_is_right).value(), 1, 1e-12);
}

TEST(WorstCase, ClimbsAboveTheRandomCasesAndShrinks) {
  SearchOptions options;
  options.sources = {{find_case_source("rays")}};
  options.climb = Climb::kRatio;
  options.cases = 200;
  options.steps = 2000;
  const Candidate candidate = fast_candidate(fast::kDirectRays, fast::kQuadratic);
  const auto worst = find_worst_case(candidate, Stage::kIntersection, options);
  ASSERT_TRUE(worst.has_value());
  EXPECT_GT(worst->height, worst->height_random);
  EXPECT_EQ(worst->the_case.scene.spheres.size(), 1u);
  EXPECT_EQ(worst->stability.outcome, Outcome::kUnstable);
  EXPECT_EQ(worst->shown.got.size(), 1u);
  const auto again = find_worst_case(candidate, Stage::kIntersection, options);
  EXPECT_EQ(again->error, worst->error);
}

}  // namespace
}  // namespace raycheck::properties
