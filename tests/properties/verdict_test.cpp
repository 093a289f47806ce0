#include "properties/verdict.h"

#include "properties/quantile_sketch.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

const Excuse kWitness = {ExcuseKind::kWitness, kExcusedChange, {0, 0x1p-52}};
const Excuse kUndecided = {ExcuseKind::kUndecided, kExcusedChange};
const Excuse kOutside = {ExcuseKind::kOutsideDomain};
const Excuse kIllConditioned = {ExcuseKind::kIllConditioned, 1e6};
constexpr double kBound = 16;

Place at_ray(std::size_t ray) {
  Place place;
  place.ray = ray;
  return place;
}

Discrepancy discrepancy(double error, std::size_t ray, Excuse excuse = {}) {
  Discrepancy result;
  result.quantity = Quantity::kParameter;
  result.place = at_ray(ray);
  result.error = error;
  result.excuse = excuse;
  return result;
}

TEST(Verdict, SetsTheLawOfItsDiscrepanciesAndKeepsThoseOfMergedOnes) {
  Verdict of_a_law("parameter");
  of_a_law.add(discrepancy(4, 1));
  Verdict of_several;
  of_several.merge(of_a_law);
  EXPECT_EQ(of_several.worst(1).front().law, "parameter");
  Verdict of_another("class");
  of_another.leave_out("why");
  of_another.merge(of_a_law);
  EXPECT_EQ(of_another.reason_left_out(), "why");
  EXPECT_EQ(of_another.worst(1).front().law, "parameter");
  of_another.shift_rays(100);
  EXPECT_EQ(of_another.worst(1).front().place.ray, 101u);
}

TEST(Verdict, CountsMeasuredErrors) {
  Verdict verdict;
  for (const double error : {3.0, 0.0, 8.0, 1.0}) {
    verdict.measured(Quantity::kParameter, at_ray(static_cast<std::size_t>(error)), error, kBound);
  }
  verdict.measured(Quantity::kFrame, at_ray(0), 2, kBound);
  EXPECT_EQ(verdict.compared(), 5u);
  const Tally& tally = verdict.tallies().at(Quantity::kParameter);
  EXPECT_EQ(tally.cases, 4u);
  EXPECT_EQ(tally.median(), 1.0);  // the lower of the middle two
  EXPECT_EQ(tally.max(), 8.0);
  EXPECT_EQ(tally.worst_place.ray, 8u);
  EXPECT_EQ(tally.wrong_answers(), 0u);
}

TEST(Verdict, HasABoundIfAllErrorsWereComparedWithTheSame) {
  const auto held_to = [](std::initializer_list<double> bounds) {
    Verdict all;
    for (const double bound : bounds) {
      Verdict one;
      one.measured(Quantity::kParameter, at_ray(0), 1, bound);
      all.merge(std::move(one));
    }
    return all.tallies().at(Quantity::kParameter).bound();
  };
  EXPECT_EQ(held_to({8}), 8.0);
  EXPECT_EQ(held_to({8, 8}), 8.0);
  EXPECT_EQ(held_to({8, 16}), std::nullopt);
  EXPECT_EQ(held_to({16, 8, 16}), std::nullopt);
  Verdict decided;
  decided.judged_right(Quantity::kClass, Expected::kMiss, 3);
  EXPECT_EQ(decided.tallies().at(Quantity::kClass).bound(), std::nullopt);
}

TEST(Verdict, ComparesABoundWithErrorsOverItsGrowth) {
  Verdict verdict;
  const auto add = [&](double error, double condition) {
    verdict.measured(Quantity::kParameter, at_ray(0), error, kBound);
    verdict.weighed(Quantity::kParameter, at_ray(0), error, {condition, 0, Outcome::kAccurate});
  };
  add(3, 1);
  add(50, 10 * kModerateCondition);
  add(kInfinity, kInfinity);
  EXPECT_EQ(verdict.tallies().at(Quantity::kParameter).max_over_growth, 5.0);
}

TEST(Verdict, CountsRightAndWrongAnswersWithoutAveragingThem) {
  Verdict verdict;
  verdict.judged_right(Quantity::kRoot, Expected::kSmallerRoot, 0);
  EXPECT_TRUE(verdict.tallies().empty());
  verdict.judged_right(Quantity::kClass, Expected::kHit, 1);
  const auto wrong = [&](Expected expected, std::size_t ray, Wrong kind, Standing standing) {
    verdict.judged_wrong({Quantity::kClass, expected, at_ray(ray), kind}, standing);
  };
  wrong(Expected::kHit, 1, Wrong::kMissed, Standing::kExcused);
  wrong(Expected::kMiss, 2, Wrong::kFalseHit, Standing::kDefect);
  wrong(Expected::kHit, 3, Wrong::kMissed, Standing::kDefect);
  wrong(Expected::kHit, 4, Wrong::kMissed, Standing::kUndecided);
  wrong(Expected::kHit, 5, Wrong::kMissed, Standing::kNotJudged);
  const Tally& tally = verdict.tallies().at(Quantity::kClass);
  EXPECT_EQ(tally.cases, 6u);
  EXPECT_EQ(tally.wrong_answers(), 5u);
  EXPECT_EQ(tally.wrong.at(Wrong::kMissed), 4u);
  EXPECT_EQ(tally.count(Standing::kDefect), 2u);
  EXPECT_EQ(tally.count(Standing::kUndecided), 1u);
  EXPECT_EQ(tally.count(Standing::kExcused), 1u);
  EXPECT_EQ(tally.count(Standing::kNotJudged), 1u);
  const Answered& hits = tally.answered[static_cast<std::size_t>(Expected::kHit)];
  EXPECT_EQ(hits.asked, 4u);  // without the answer that is not judged
  EXPECT_EQ(hits.right, 1u);
  EXPECT_EQ(tally.worst_place.ray, 2u);  // the first without an excuse
  EXPECT_FALSE(tally.median().has_value());
  EXPECT_FALSE(tally.max().has_value());
}

TEST(Verdict, HoldsWithoutADefect) {
  for (const Excuse& excuse : {kIllConditioned, kWitness, kUndecided, kOutside}) {
    Verdict verdict;
    verdict.add(discrepancy(100, 0, excuse));
    EXPECT_TRUE(verdict.holds());
    EXPECT_EQ(verdict.holds(true), excuse.standing() == Standing::kNotJudged);
    EXPECT_EQ(verdict.count(excuse.standing()), 1u);
    verdict.add(discrepancy(20, 1));
    EXPECT_FALSE(verdict.holds());
    EXPECT_EQ(verdict.discrepancies(), 2u);
  }
}

TEST(Verdict, NamesTheFirstQuestionThatWasAnsweredRightlyTooFewTimes) {
  Verdict verdict;
  EXPECT_FALSE(verdict.too_few_right(1));
  verdict.judged_right(Quantity::kClass, Expected::kMiss, 5);
  EXPECT_FALSE(verdict.too_few_right(5));
  const std::pair too_few_misses(Quantity::kClass, Expected::kMiss);
  EXPECT_EQ(verdict.too_few_right(6), too_few_misses);
  verdict.judged_wrong({Quantity::kClass, Expected::kHit, at_ray(0), Wrong::kMissed},
                       Standing::kExcused);
  const std::pair too_few_hits(Quantity::kClass, Expected::kHit);
  EXPECT_EQ(verdict.too_few_right(1), too_few_hits);
  Verdict measured;
  measured.measured(Quantity::kParameter, at_ray(0), kBound + 1, kBound);
  const std::pair too_few_values(Quantity::kParameter, Expected::kValue);
  EXPECT_EQ(measured.too_few_right(1), too_few_values);
  Verdict both = measured;
  both.measured(Quantity::kHitPoint, at_ray(0), kBound, kBound);
  EXPECT_FALSE(both.too_few_right(1));  // values of all quantities count together
  measured.count_ill_conditioned(Quantity::kParameter);
  EXPECT_FALSE(measured.too_few_right(1));
}

TEST(Verdict, PutsTheWorstFirst) {
  Verdict verdict;
  verdict.add(discrepancy(kInfinity, 0, kWitness));
  verdict.add(discrepancy(20, 5));
  verdict.add(discrepancy(30, 9));
  verdict.add(discrepancy(20, 2));
  verdict.add(discrepancy(kInfinity, 7));
  std::vector<std::size_t> rays;
  for (const Discrepancy& d : verdict.worst(10)) rays.push_back(d.place.ray);
  EXPECT_EQ(rays, (std::vector<std::size_t>{7, 9, 2, 5, 0}));
  EXPECT_EQ(verdict.worst(2).size(), 2u);
}

TEST(Verdict, LetsNoQuantityHideTheOthers) {
  std::vector<Discrepancy> all;
  for (const double error : {40.0, 50.0, 60.0}) all.push_back(discrepancy(error, 1));
  all.push_back(discrepancy(20, 2));
  all.back().quantity = Quantity::kFrame;
  all.push_back(discrepancy(kInfinity, 3, kWitness));
  const auto sorted = worst_first(all);
  std::vector<double> errors;
  for (const Discrepancy& d : sorted) errors.push_back(d.error);
  ASSERT_EQ(errors.size(), 5u);
  EXPECT_EQ(std::set<double>(errors.begin(), errors.begin() + 2), (std::set<double>{20, 60}));
  EXPECT_EQ(errors[2], 50);
  EXPECT_EQ(errors[3], 40);
  EXPECT_EQ(errors[4], kInfinity);  // excused
}

TEST(Verdict, KeepsTheWorstAndCountsAll) {
  constexpr std::size_t kCount = 5 * kKeptDiscrepancies;
  Verdict verdict;
  for (std::size_t k = 0; k < kCount; ++k) {
    verdict.add(discrepancy(static_cast<double>((k * 389) % kCount), k));
  }
  EXPECT_EQ(verdict.discrepancies(), kCount);
  const auto worst = verdict.worst(kKeptDiscrepancies);
  ASSERT_EQ(worst.size(), kKeptDiscrepancies);
  for (std::size_t k = 0; k < worst.size(); ++k) {
    EXPECT_EQ(worst[k].error, static_cast<double>(kCount - 1 - k));
  }
  EXPECT_LE(verdict.worst(kCount).size(), 2 * kKeptDiscrepancies);
}

/// A verdict on a few answers of all kinds, with many ties.
Verdict random_verdict(std::mt19937_64& random) {
  const auto below = [&](std::uint64_t end) { return random() % end; };
  Verdict verdict;
  for (std::uint64_t k = 0; k < 1 + below(5); ++k) {
    const Place place = {below(4), std::nullopt, below(3)};
    const double error = static_cast<double>(below(30)) * 1.37;
    const double condition = static_cast<double>(below(100)) / 3;
    verdict.measured(Quantity::kParameter, place, error, static_cast<double>(8 + below(2)));
    verdict.weighed(Quantity::kParameter, place, error, {condition, error, Outcome::kAccurate});
    const auto wrong = static_cast<Wrong>(below(kWrongCount));
    const Excuse excuse =
        std::array{Excuse{}, kUndecided, kWitness, kOutside}[below(kStandingCount)];
    const auto expected = static_cast<Expected>(below(kExpectedCount));
    if (wrong == Wrong::kNot) {
      verdict.judged_right(Quantity::kClass, expected, 1);
    } else {
      verdict.judged_wrong({Quantity::kClass, expected, place, wrong}, excuse.standing());
    }
    Discrepancy found = discrepancy(error, place.ray, excuse);
    found.what = std::to_string(below(3));
    found.condition = condition;
    verdict.add(found);
  }
  return verdict;
}

void expect_equal(const Tally& a, const Tally& b) {
  const auto parts = [](const Tally& t) {
    return std::tie(t.cases, t.right, t.wrong, t.wrong_by_standing, t.errors, t.conditions, t.worst,
                    t.worst_condition, t.worst_ratio, t.outcomes, t.max_over_growth, t.least_bound,
                    t.greatest_bound);
  };
  EXPECT_TRUE(parts(a) == parts(b));
  for (std::size_t k = 0; k < kExpectedCount; ++k) {
    EXPECT_EQ(a.answered[k].asked, b.answered[k].asked);
    EXPECT_EQ(a.answered[k].right, b.answered[k].right);
  }
  EXPECT_FALSE(is_earlier(a.worst_place, b.worst_place) ||
               is_earlier(b.worst_place, a.worst_place));
}

TEST(Verdict, DoesNotDependOnTheOrderOfMerging) {
  std::mt19937_64 random(8);
  for (int round = 0; round < 20; ++round) {
    std::vector<Verdict> parts;
    for (int k = 0; k < 300; ++k) parts.push_back(random_verdict(random));
    Verdict in_order;
    for (const Verdict& part : parts) in_order.merge(part);
    // Some parts are merged with one another first.
    std::shuffle(parts.begin(), parts.end(), random);
    while (parts.size() > 1) {
      const std::size_t into = random() % (parts.size() - 1);
      parts[into].merge(std::move(parts.back()));
      parts.pop_back();
    }
    ASSERT_EQ(parts[0].tallies().size(), in_order.tallies().size());
    for (const auto& [quantity, tally] : in_order.tallies()) {
      expect_equal(parts[0].tallies().at(quantity), tally);
      EXPECT_EQ(tally.cases, tally.right + tally.wrong_answers() + tally.errors.count());
    }
    for (const Standing standing :
         {Standing::kDefect, Standing::kUndecided, Standing::kExcused, Standing::kNotJudged}) {
      EXPECT_EQ(parts[0].count(standing), in_order.count(standing));
    }
    const auto one = parts[0].worst(100), other = in_order.worst(100);
    ASSERT_EQ(one.size(), 100u);
    for (std::size_t k = 0; k < one.size(); ++k) {
      EXPECT_EQ(one[k].error, other[k].error);
      EXPECT_EQ(one[k].place.ray, other[k].place.ray);
      EXPECT_EQ(one[k].what, other[k].what);
    }
  }
}

QuantileSketch sketch_of(const std::vector<double>& numbers) {
  QuantileSketch sketch;
  for (const double number : numbers) sketch.add(number);
  return sketch;
}

struct Sample {
  std::string name;
  std::vector<double> numbers;
};

std::vector<Sample> samples() {
  std::mt19937_64 random(5);
  std::vector<Sample> all = {
      {"one", {3.7}},
      {"all equal", std::vector<double>(1000, 0.1)},
      {"zeros and infinities", {0, kInfinity, 0, 0, kInfinity, 1}},
      {"the ends of the range", {kLargest, 1e308, std::nextafter(kLargest, 0), kSmallest, 0}},
      {"subnormal", {kSmallest, 3 * kSmallest, 0x1.fffffp-1040, kSmallestNormal / 3}},
      {"around a power of two", {std::nextafter(1, 0), 1, std::nextafter(1, 2), 0.5, 2}}};
  const auto add = [&](const std::string& name, std::size_t count, auto draw) {
    all.push_back({name, {}});
    for (std::size_t k = 0; k < count; ++k) all.back().numbers.push_back(draw());
  };
  std::uniform_real_distribution<double> uniform(0, 16), exponent(-1074, 1023);
  add("uniform", 5000, [&] { return uniform(random); });
  add("all magnitudes", 5000, [&] { return std::exp2(exponent(random)); });
  add("integers", 5000, [&] { return static_cast<double>(random() % 4096); });
  add("subnormals", 500, [&] { return kSmallest * static_cast<double>(random() % (1u << 30)); });
  return all;
}

TEST(QuantileSketch, IsAtLeastTheExactQuantileAndWithinItsResolution) {
  int compared = 0;
  for (const auto& [name, numbers] : samples()) {
    const QuantileSketch sketch = sketch_of(numbers);
    std::vector<double> sorted = numbers;
    std::sort(sorted.begin(), sorted.end());
    for (const double share : {0.0, 0.001, 0.1, 0.5, 0.9, 0.999, 1.0}) {
      const double rank = std::ceil(share * static_cast<double>(sorted.size()) - 1e-9);
      const double exact = sorted[static_cast<std::size_t>(std::max(rank - 1, 0.0))];
      const double got = sketch.quantile(share).value();
      EXPECT_GE(got, exact) << name << ", " << share;
      if (std::isinf(exact)) continue;
      EXPECT_TRUE(got == exact || got - exact < exact * kSketchResolution) << name << ", " << share;
      ++compared;
    }
    EXPECT_EQ(sketch.max(), sorted.back()) << name;
    EXPECT_EQ(sketch.quantile(1), sorted.back()) << name;
    EXPECT_EQ(sketch.count(), numbers.size());
  }
  EXPECT_GE(compared, 60);
}

TEST(QuantileSketch, DoesNotDependOnTheOrderOfAddingAndMerging) {
  std::mt19937_64 random(6);
  for (auto [name, numbers] : samples()) {
    const QuantileSketch expected = sketch_of(numbers);
    for (int round = 0; round < 10; ++round) {
      std::shuffle(numbers.begin(), numbers.end(), random);
      std::vector<QuantileSketch> parts(1 + random() % 40);
      for (const double number : numbers) parts[random() % parts.size()].add(number);
      while (parts.size() > 1) {
        const std::size_t into = random() % (parts.size() - 1);
        parts[into].merge(parts.back());
        parts.pop_back();
      }
      EXPECT_TRUE(parts[0] == expected) << name;
      for (const double share : {0.01, 0.5, 0.99}) {
        EXPECT_EQ(parts[0].quantile(share), expected.quantile(share)) << name;
      }
    }
    QuantileSketch with_another = expected;
    with_another.add(1e-5);
    EXPECT_FALSE(with_another == expected) << name;
  }
}

TEST(QuantileSketch, HoldsOnlyItsBinsAndWaitingNumbers) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> binade(1, 2);
  QuantileSketch sketch;
  for (int k = 0; k < 200000; ++k) sketch.add(binade(random));
  EXPECT_LE(sketch.size(), 2 * (1 / kSketchResolution + 1));
  QuantileSketch merged;
  for (int k = 0; k < 100; ++k) merged.merge(sketch);
  EXPECT_LE(merged.size(), 2 * (1 / kSketchResolution + 1));
  EXPECT_EQ(merged.count(), 100 * sketch.count());
  EXPECT_EQ(merged.quantile(0.3), sketch.quantile(0.3));
  merged.merge(merged);
  EXPECT_EQ(merged.count(), 200 * sketch.count());
}

TEST(QuantileSketch, CountsNaNAsInfiniteAndRefusesNegatives) {
  EXPECT_EQ(sketch_of({std::nan("")}).max(), kInfinity);
  EXPECT_THROW(sketch_of({-1}), std::invalid_argument);
}

}  // namespace
}  // namespace raycheck::properties
