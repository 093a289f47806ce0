#include "reference/account/internal/answer_conditions.h"

#include <algorithm>
#include <cmath>

namespace raycheck::reference {
namespace {

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

}  // namespace raycheck::reference
