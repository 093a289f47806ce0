#include "properties/quantile_sketch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/numbers.h"

namespace raycheck::properties {
namespace {

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

TEST(QuantileSketch, IsTheSameInWhateverOrderNumbersAreAddedAndMerged) {
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

TEST(QuantileSketch, HoldsNoMoreThanItsBinsAndWhatWaits) {
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

TEST(QuantileSketch, CountsWhatIsNoNumberAsInfiniteAndRefusesNegatives) {
  EXPECT_EQ(sketch_of({std::nan("")}).max(), kInfinity);
  EXPECT_THROW(sketch_of({-1}), std::invalid_argument);
}

}  // namespace
}  // namespace raycheck::properties
