#include "reference/account/internal/answer_conditions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace raycheck::reference {
namespace {

/// Shares of an answer's slack in which witnesses are looked for. Rounding a witness moves a double
/// root by the square root of the discriminant's change: the first share leaves room for that, the
/// last is nearly all of the slack.
constexpr std::array<double, 3> kSharesOfSlack = {1 - 0x1p-3, 1 - 0x1p-8, 1 - 0x1p-30};

/// How far "just inside" a condition is, as a share of its reach.
constexpr double kInside = 0x1p-20;

/// Whether a condition without an equation can be met. A line misses where the discriminant is
/// negative, or 0 if tangents count as misses; a root at the origin is a hit of the nearest, a
/// miss of the smaller root where that is the other one.
bool may_be(AnswerBox& box, const Variation& f, const Condition& condition) {
  if (condition.sign == 0) {
    Enclosure most = box.most_near_double_root();
    if (condition.what == Decider::kDiscriminant) most *= Enclosure(most);
    return (abs(f.value) - f.most - most).certain_sign().value_or(-1) <= 0;
  }
  const bool tangent_misses = box.around().tangent == scene::Tangent::kMiss;
  const bool zero_counts = condition.what == Decider::kDiscriminant
                               ? tangent_misses == (condition.sign < 0)
                               : condition.what == Decider::kConstant && condition.sign > 0 &&
                                     box.around().root == scene::Root::kSmaller;
  if (zero_counts && f.may_be_zero()) return true;
  return condition.sign > 0 ? f.may_be_positive() : f.may_be_negative();
}

bool is_refuted(AnswerBox& box, const Condition& condition) {
  const Variation& f = box.variation(condition.what);
  if (!condition.zero) return !may_be(box, f, condition);
  const Variation& g = box.variation(*condition.zero);
  if (!g.may_be_zero() || !f.may_be_at_least_zero()) return true;
  const auto optimum = highest_where_zero(linear_form(f), linear_form(g));
  if (!optimum) return false;
  // Where g = 0, f equals f + multiplier g, which may vary less.
  const Enclosure multiplier = Enclosure(optimum->multiplier, kVariationBits) * f.most / g.most;
  std::vector<Enclosure> reach;
  for (std::size_t k = 0; k < f.reach.size(); ++k) {
    reach.push_back(f.reach[k] + multiplier * g.reach[k]);
  }
  const Variation both{f.value + multiplier * g.value, reach, sum_of_sizes(reach)};
  return !both.may_be_at_least_zero();
}

}  // namespace

std::vector<std::vector<Condition>> alternatives(const AnswerBox& box) {
  const bool only_smaller = box.around().root == scene::Root::kSmaller;
  if (!box.answer()) {
    std::vector<std::vector<Condition>> result = {
        {{{}, Decider::kDiscriminant, -1}},
        {{{}, Decider::kConstant, 1}, {{}, Decider::kLinear, -1}}};
    if (only_smaller) result.push_back({{{}, Decider::kConstant, -1}});
    return result;
  }
  if (!(std::isfinite(*box.answer()) && *box.answer() >= 0)) return {};
  std::vector<std::vector<Condition>> result = {{{Decider::kAtAnswer, Decider::kBeforeMiddle}},
                                                {{{}, Decider::kDiscriminant},
                                                 {{}, Decider::kMiddleOffAnswer, 0},
                                                 {{}, Decider::kDiscriminant, 0}}};
  if (!only_smaller) result.push_back({{Decider::kAtAnswer, Decider::kOtherBehind}});
  return result;
}

bool are_refuted(AnswerBox& box, const std::vector<Condition>& all) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Condition& condition) { return is_refuted(box, condition); });
}

std::vector<double> on_zero(const AnswerBox& box, Decider decider, const Variation& variation,
                            std::vector<double> t) {
  const std::vector<Enclosure>& reach = variation.reach;
  const Enclosure off = box.value_at(decider, t);
  std::size_t moved = t.size();
  double least = 0;
  for (std::size_t k = 0; k + 1 < t.size(); ++k) {
    const double step = (off / reach[k]).lower();
    const bool is_possible = std::abs(t[k] - step) <= 1;
    if (is_possible && (moved == t.size() || std::abs(step) < std::abs(least))) {
      moved = k;
      least = step;
    }
  }
  if (moved < t.size()) t[moved] -= least;
  return t;
}

std::vector<std::vector<double>> places(const AnswerBox& box, const std::vector<Condition>& all,
                                        const VariationOf& variation_of) {
  std::vector<std::vector<double>> result;
  const auto slopes = [&](Decider decider, int sign) {
    LinearForm f = linear_form(variation_of(decider));
    f.value *= sign;
    for (double& slope : f.slope) slope *= sign;
    return f;
  };
  for (const Condition& condition : all) {
    const LinearForm f = slopes(condition.what, condition.sign);
    if (!condition.zero) {
      if (condition.sign == 0) continue;
      result.push_back(highest(f));
      result.emplace_back(f.slope.size(), 0.0);
      continue;
    }
    for (const double share : kSharesOfSlack) {
      LinearForm g = slopes(*condition.zero, 1);
      g.slope.back() *= share;
      if (auto optimum = highest_where_zero(f, g)) {
        optimum->t.back() *= share;
        result.push_back(
            on_zero(box, *condition.zero, variation_of(*condition.zero), std::move(optimum->t)));
      }
    }
  }
  // Just inside one condition, as far inside another as possible: for two, or near a double root.
  const auto just_inside = [&](LinearForm first, const LinearForm& second) {
    first.value -= kInside;
    if (auto optimum = highest_where_zero(second, first)) result.push_back(std::move(optimum->t));
  };
  if (all.size() >= 2) {
    const LinearForm first = slopes(all[0].what, all[0].sign);
    for (const int sign : {1, -1}) {
      if (all[1].sign != -sign) just_inside(first, slopes(all[1].what, sign));
    }
  }
  return result;
}

}  // namespace raycheck::reference
