// How long vectors are over a box, against points of it.

#include "reference/account/internal/vector_length.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "properties/cases/random.h"

namespace raycheck::reference {
namespace {

using properties::Random;

constexpr std::size_t kInputs = 7;

Variation random_variation(Random& random, double value, double reach) {
  Variation result{Enclosure(value, kVariationBits), {}};
  for (std::size_t k = 0; k < kInputs; ++k) {
    result.reach.emplace_back(random.between(-reach, reach), kVariationBits);
  }
  result.most = sum_of_sizes(result.reach);
  return result;
}

/// A vector in the plane of x and y, and a length.
VectorAndLength random_vector(Random& random) {
  const double reach = random.between(0, 0.3);
  VectorAndLength both{
      {random_variation(random, random.between(-1, 1), reach),
       random_variation(random, random.between(-1, 1), reach), random_variation(random, 0, 0)},
      random_variation(random, random.between(0, 2), 0.01)};
  return both;
}

double at(const Variation& variation, const std::vector<double>& t) {
  double value = variation.value.lower();
  for (std::size_t k = 0; k < t.size(); ++k) value += t[k] * variation.reach[k].lower();
  return value;
}

/// The vector's length less what it is compared with.
double excess_at(const VectorAndLength& both, const std::vector<double>& t) {
  return std::hypot(at(both.vector[0], t), at(both.vector[1], t), at(both.vector[2], t)) -
         at(both.length, t);
}

/// Every corner of the box.
template <class Visit>
void visit_corners(Visit visit) {
  for (unsigned corner = 0; corner < 1U << kInputs; ++corner) {
    std::vector<double> t;
    for (unsigned k = 0; k < kInputs; ++k) t.push_back(((corner >> k) & 1U) != 0 ? 1 : -1);
    visit(t);
  }
}

/// A convex function is largest at a corner.
TEST(VectorLength, IsShorterWhereItIsAtEveryCorner) {
  Random random(4);
  int shorter = 0;
  int longer_somewhere = 0;
  int open = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const VectorAndLength both = random_vector(random);
    double most = -1;
    visit_corners([&](const std::vector<double>& t) { most = std::max(most, excess_at(both, t)); });
    bool is_found = false;
    const bool is_certain = is_shorter(both, {0, 0, 1}, [&](const std::vector<double>& t) {
      is_found = excess_at(both, t) > 0;
      return is_found;
    });
    ASSERT_FALSE(is_certain && most > 1e-9) << most;
    ASSERT_FALSE(is_found && most < 0) << most;
    shorter += is_certain ? 1 : 0;
    longer_somewhere += is_found ? 1 : 0;
    open += !is_certain && !is_found ? 1 : 0;
  }
  EXPECT_GE(shorter, 300);
  EXPECT_GE(longer_somewhere, 300);
  EXPECT_LE(open, 2);
}

TEST(VectorLength, IsShortestWhereNoOtherPointIsShorter) {
  Random random(5);
  int certainly_longer = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    VectorAndLength both = random_vector(random);
    both.vector[2] = random_variation(random, random.between(-1, 1), 0.2);
    const Shortest least = shortest(both);
    const auto length_at = [&](const std::vector<double>& t) {
      return std::hypot(at(both.vector[0], t), at(both.vector[1], t), at(both.vector[2], t));
    };
    const double shortest_length = length_at(least.t);
    const Variation room = less_share_along(both, least.direction);
    const bool is_longer = (room.value + room.most).certain_sign() == -1;
    certainly_longer += is_longer ? 1 : 0;
    for (int place = 0; place < 50; ++place) {
      std::vector<double> t;
      for (std::size_t k = 0; k < kInputs; ++k) t.push_back(random.between(-1, 1));
      ASSERT_GE(length_at(t), shortest_length - 1e-3);
      ASSERT_TRUE(!is_longer || excess_at(both, t) > 0);
    }
  }
  EXPECT_GE(certainly_longer, 300);
}

}  // namespace
}  // namespace raycheck::reference
