// Linear programs over a box, against points of it and against their own duals.

#include "reference/account/internal/box_optimum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "properties/cases/random.h"

namespace raycheck::reference {
namespace {

using properties::Random;

double at(const LinearForm& form, const std::vector<double>& t) {
  double value = form.value;
  for (std::size_t k = 0; k < t.size(); ++k) value += form.slope[k] * t[k];
  return value;
}

LinearForm random_form(Random& random, std::size_t inputs) {
  LinearForm form{random.between(-2, 2), {}};
  for (std::size_t k = 0; k < inputs; ++k) {
    // Equal ratios and zeros are usual: a ray's origin and a centre enter as their difference.
    form.slope.push_back(static_cast<double>(random.integer(-3, 3)) / 4);
  }
  return form;
}

TEST(BoxOptimum, WithoutAnEquationIsACorner) {
  EXPECT_EQ(highest({1, {2, -3, 0}}), (std::vector<double>{1, -1, 0}));
}

TEST(BoxOptimum, IsEmptyWhereTheEquationHasNoSolution) {
  EXPECT_FALSE(highest_where_zero({0, {1, 1}}, {3, {1, -1}}));
  EXPECT_FALSE(highest_where_zero({0, {1, 1}}, {-3, {1, -1}}));
  EXPECT_TRUE(highest_where_zero({0, {1, 1}}, {2, {1, -1}}));
}

TEST(BoxOptimum, MeetsTheEquationAndItsMultiplierProvesIt) {
  constexpr double kRounding = 1e-12;
  Random random(3);
  int found = 0;
  for (int k = 0; k < 5000; ++k) {
    const auto inputs = static_cast<std::size_t>(random.integer(1, 12));
    const LinearForm f = random_form(random, inputs);
    const LinearForm g = random_form(random, inputs);
    const auto optimum = highest_where_zero(f, g);
    double reach = 0;
    for (const double slope : g.slope) reach += std::abs(slope);
    if (reach == 0) continue;
    ASSERT_EQ(optimum.has_value(), std::abs(g.value) <= reach) << k;
    if (!optimum) continue;
    ++found;
    for (const double t : optimum->t) ASSERT_LE(std::abs(t), 1 + kRounding);
    ASSERT_NEAR(at(g, optimum->t), 0, kRounding) << k;
    // Weak duality: where g is 0, f is the combination, whose largest value is this.
    LinearForm combined{f.value + optimum->multiplier * g.value, {}};
    for (std::size_t j = 0; j < inputs; ++j) {
      combined.slope.push_back(f.slope[j] + optimum->multiplier * g.slope[j]);
    }
    ASSERT_NEAR(at(combined, highest(combined)), at(f, optimum->t), kRounding) << k;
  }
  EXPECT_GT(found, 2000);
}

/// What the multipliers prove: nowhere is the least form larger.
double bound(const std::vector<LinearForm>& forms, const std::vector<double>& multipliers) {
  double result = 0;
  for (std::size_t i = 0; i < forms.size(); ++i) result += multipliers[i] * forms[i].value;
  for (std::size_t k = 0; k < forms.front().slope.size(); ++k) {
    double slope = 0;
    for (std::size_t i = 0; i < forms.size(); ++i) slope += multipliers[i] * forms[i].slope[k];
    result += std::abs(slope);
  }
  return result;
}

TEST(BoxOptimum, OfTheLeastOfSeveralFormsIsProvenByTheirSum) {
  properties::Random random(2);
  for (int trial = 0; trial < 3000; ++trial) {
    const auto inputs = static_cast<std::size_t>(random.integer(1, 20));
    std::vector<LinearForm> forms(static_cast<std::size_t>(random.integer(1, 9)));
    for (LinearForm& form : forms) {
      form.value = random.one_in(3) ? random.small_integer(2) : random.between(-2, 2);
      for (std::size_t k = 0; k < inputs; ++k) {
        form.slope.push_back(random.one_in(3) ? random.small_integer(1) : random.between(-1, 1));
      }
    }
    const LeastOptimum optimum = highest_least(forms);
    double sum = 0;
    for (const double multiplier : optimum.multipliers) {
      ASSERT_GE(multiplier, 0);
      sum += multiplier;
    }
    ASSERT_NEAR(sum, 1, 1e-9);
    for (const double t : optimum.t) ASSERT_LE(std::abs(t), 1);
    double least = at(forms.front(), optimum.t);
    for (const LinearForm& form : forms) least = std::min(least, at(form, optimum.t));
    ASSERT_NEAR(optimum.least, least, 1e-12);
    ASSERT_NEAR(bound(forms, optimum.multipliers), least, 1e-9);
  }
}

}  // namespace
}  // namespace raycheck::reference
